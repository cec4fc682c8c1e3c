// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "golden/update/traffic.h"
#include "testbench/eval/measure.h"

namespace cbvh::testbench {

/// A way to an updated quantized tree, as the paper's Figure 1 and Table 3 name them.
struct Strategy {
  const char* key;
  const char* name;
  CodeCounts SceneMeasure::*counts;  ///< null: a float tree, then a separate top-down compression
  std::size_t levels;                ///< of a treelet
};

/// B, and streaming with relative and modulo codes, without treelets (0) and with one more level (1).
inline constexpr std::array<Strategy, 5> kStrategies = {{{"baseline", "B", nullptr, 0},
                                                         {"r0", "R0", &SceneMeasure::relative, 1},
                                                         {"r1", "R1", &SceneMeasure::relative, 2},
                                                         {"m0", "M0", &SceneMeasure::modulo, 1},
                                                         {"m1", "M1", &SceneMeasure::modulo, 2}}};

/// What is updated.
struct Update {
  const char* key;
  const char* name;
  golden::Traffic golden::UpdateTraffic::*traffic;
};

inline constexpr std::array<Update, 2> kUpdates = {
    {{"lbvh", "LBVH", &golden::UpdateTraffic::lbvh}, {"refit", "refit", &golden::UpdateTraffic::refit}}};

/// Traffic in bytes a primitive, as Figure 1 stacks it.
struct TrafficParts {
  double separate;      ///< of the separate compression
  double update;        ///< of construction or refit
  double backtracking;  ///< of repairs
  double total() const { return separate + update + backtracking; }
};

TrafficParts baseline_parts(const Update& update, std::uint64_t primitives, std::uint64_t pairs);
TrafficParts streaming_parts(const Update& update, std::uint64_t primitives, std::uint64_t pairs,
                             std::uint64_t backtracks);
TrafficParts traffic_parts(const Update& update, const Strategy& strategy, const SceneMeasure& scene);

}  // namespace cbvh::testbench
