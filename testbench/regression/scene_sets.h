// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "golden/build/float_tree.h"
#include "testbench/regression/plan.h"

namespace cbvh::testbench {

/// The unit that whole scenes run through.
constexpr const char* kSceneUnit = "stream_compressor";

/// A scene and its float tree, which all of its sets share.
struct Scene {
  std::string name;  ///< as the command line has it
  std::shared_ptr<const golden::FloatTree> floats;
};

/// Adds, for each scene, whole trees through the RTL stream compressor against the golden's top-down tree: a check for
/// each field of each pair, for the root's context and for the number of backtracks. A set is one tree. Both codes and
/// collectors go with every treelet depth; the other modes and numbers of bits are tried once each.
void append_scene_sets(const std::vector<Scene>& scenes, const std::vector<int>& treelets, const std::vector<int>& bits,
                       const std::vector<RunOptions>& modes, const RegressionOptions& options,
                       std::vector<PlannedSet>& plan);

}  // namespace cbvh::testbench
