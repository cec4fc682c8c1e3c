// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "golden/options/options.h"
#include "golden/scene/mesh.h"

namespace cbvh::golden {

struct ProceduralScene {
  std::string name;
  std::string meaning;  ///< and how many triangles result
  std::vector<Option> options;
  Mesh (*make)(const OptionValues&);
};

/// "NAME[,key=value...]" to a mesh. `spec` is the place that errors name.
Mesh make_procedural_scene(const std::string& spec, std::string_view description);

// One of each file in this folder.
ProceduralScene cloth_scene();
ProceduralScene soup_scene();
ProceduralScene spheres_scene();
ProceduralScene terrain_scene();
ProceduralScene hairball_scene();
ProceduralScene city_scene();
ProceduralScene explode_scene();
ProceduralScene morph_scene();

// Options that most scenes have.
inline constexpr std::uint64_t kMostTriangles = std::uint64_t{1} << 22;
Option triangles_option(std::uint64_t initial, std::uint64_t least);
Option seed_option();

}  // namespace cbvh::golden
