// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "testbench/eval/runtime.h"

namespace cbvh::testbench {

/// The treelet depths of the paper's Table 1: 1 (no treelets) to 4 levels.
inline constexpr std::size_t kTreeletDepths = 4;

/// What streaming with one code cost.
struct CodeCounts {
  std::array<std::uint64_t, kTreeletDepths> backtracks{};  ///< [D - 1]: with treelets of D levels
  std::vector<std::uint64_t> depth_histogram;              ///< without treelets; [d]: d levels below the arriving pair
};

/// One minimum scale of the paper's Figure 10; modulo codes.
struct SweepPoint {
  std::optional<int> min_scale;  ///< empty: the exactness limit
  std::uint64_t one_level = 0;   ///< backtracks without treelets
  std::uint64_t four_levels = 0;
  double sah = 0;  ///< of the quantized tree
};

/// All counts of one scene.
struct SceneMeasure {
  std::string name;
  std::uint64_t triangles = 0;
  std::uint64_t leaves = 0;
  std::uint64_t pairs = 0;
  int min_scale = 0;
  double sah_float = 0;
  double sah_quantized = 0;
  CodeCounts relative;
  CodeCounts modulo;
  std::vector<SweepPoint> sweep;
  std::optional<RuntimeRow> runtime;
  std::uint64_t checks = 0;
  std::vector<std::string> failures;

  double leaf_size() const { return static_cast<double>(triangles) / static_cast<double>(leaves); }
};

struct EvalJob {
  std::vector<std::string> scenes;
  EvalRules rules;
  std::vector<std::optional<int>> sweep;  ///< empty: no sweep
  MeasureRuntime runtime;                 ///< empty: no runtimes
  unsigned threads = 0;
};

/// Loads the scenes, builds their trees and streams each with both codes and all treelet depths. Checked of each scene:
/// every streamed tree has the digest of the top-down one, and check_depths. Throws InputError when a scene cannot be
/// read or is given twice, before anything is measured.
std::vector<SceneMeasure> measure_scenes(const EvalJob& job);

/// Checks that backtracks with treelets of D levels are the iterations without treelets at depth D and below.
void check_depths(SceneMeasure& scene);

}  // namespace cbvh::testbench
