// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <vector>

#include "testbench/eval/measure.h"

namespace cbvh::testbench {

// The paper's own figures, as its text has them. Its Table 3 and Figures 7 and 10 are drawings without numbers.

/// A scene of the paper's Table 2.
struct PaperScene {
  const char* name;
  std::array<double, kRuntimes> milliseconds;
  double leaf_size;
};

const std::vector<PaperScene>& paper_scenes();

/// The last row of Table 2: the runtimes over the float build's.
inline constexpr std::array<double, kRuntimes> kPaperAverageRuntime = {1.00, 1.36, 1.52, 0.80};

/// A row of the paper's Table 1: a figure of relative codes without treelets and with 2, 3 and 4 levels, then of modulo
/// codes.
using PaperRow = std::array<double, 2 * kTreeletDepths>;

/// One quantity of the paper's Table 1 over its 16 scenes.
struct PaperSpread {
  PaperRow least;
  PaperRow most;
  PaperRow average;
};

/// Normalized to relative codes without treelets.
extern const PaperSpread kPaperBacktracks;
/// Normalized to the separate top-down compression.
extern const PaperSpread kPaperLbvhTraffic;
extern const PaperSpread kPaperRefitTraffic;

/// What a scene of ours has to do with the paper's.
struct PaperCounterpart {
  const PaperScene* same = nullptr;  ///< the paper's scene, where ours is truly that one
  std::string note;                  ///< empty: nothing to say
};

PaperCounterpart paper_counterpart(const SceneMeasure& scene);

}  // namespace cbvh::testbench
