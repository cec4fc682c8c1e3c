// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>

#include "golden/quantize/grid.h"
#include "golden/scene/mesh.h"

namespace cbvh::testbench {

/// What an evaluation fixes for all its scenes; N is 6.
struct EvalRules {
  golden::ScaleRule scale_rule = golden::ScaleRule::equation2;
  std::optional<int> min_scale;  ///< empty: each scene's exactness limit
};

/// The configurations of the paper's Table 2, in its order: the float build, that with a top-down pass, streaming with
/// relative codes, streaming with modulo codes and treelets of 4 levels.
inline constexpr std::size_t kRuntimes = 4;

/// A scene's row of the paper's Table 2.
struct RuntimeRow {
  std::string scene;
  std::array<double, kRuntimes> milliseconds;     ///< at 1 GHz
  std::array<double, kRuntimes> over_dram_bound;  ///< cycles over those its bytes need at the memory's peak rate
  double leaf_size;                               ///< triangles a leaf
};

/// Builds the scene's tree in all four configurations, cycle by cycle.
using MeasureRuntime = std::function<RuntimeRow(const golden::Mesh&, const EvalRules&)>;

/// Who measures Table 2; empty where no cycle-level pipeline is part of this build, and then there is no Table 2.
MeasureRuntime runtime_measurement();

}  // namespace cbvh::testbench
