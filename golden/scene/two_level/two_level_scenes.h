// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "golden/options/options.h"
#include "golden/scene/instances.h"

namespace cbvh::golden {

/// A way to make a scene of instances from one mesh.
struct TwoLevelKind {
  std::string name;
  std::string meaning;
  std::vector<Option> options;
  TwoLevelScene (*make)(Mesh mesh, const OptionValues& options);
};

/// All kinds, in the order in which help and errors name them.
const std::vector<TwoLevelKind>& two_level_kinds();

/// The scene that `spec` names: "KIND[,key=value...]:SCENE", SCENE as load_scene takes it; for example
/// "bounce,count=256,time=0.5:armadillo.glb". Throws InputError, and nothing else, when there is no valid scene.
TwoLevelScene load_two_level_scene(const std::string& spec);

/// The kinds and their options, for help.
std::string two_level_help();

// One of each file in this folder.
TwoLevelKind bounce_kind();
TwoLevelKind deal_kind();

}  // namespace cbvh::golden
