// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "testbench/eval/measure.h"

namespace cbvh::testbench {

/// One builder's tree of one scene. N = 6, e_min the scene's exactness limit.
struct BuilderMeasure {
  std::string scene;
  std::string builder;  ///< "NAME[,key=value...]"
  std::uint64_t triangles = 0;
  std::uint64_t references = 0;
  std::uint64_t leaves = 0;
  std::uint64_t pairs = 0;
  int depth = 0;
  double build_seconds = 0;
  double sah_float = 0;  ///< C_T = C_I = 1
  double sah_quantized = 0;
  CodeCounts relative;
  CodeCounts modulo;
  std::uint64_t checks = 0;
  std::vector<std::string> failures;
};

struct BuildersJob {
  std::vector<std::string> scenes;
  std::vector<std::string> builders;
  unsigned repeats = 1;  ///< builds of which the fastest counts
};

/// Measures every builder on every scene, scene by scene. Checked of each tree: check_tree, its compressed form
/// encloses it, and streamed through the RTL with both codes and every treelet depth it is the top-down tree bit for
/// bit, with as many backtracks as the golden counts. Throws InputError for a scene or builder that is none, before
/// anything is measured.
std::vector<BuilderMeasure> measure_builders(const BuildersJob& job);

}  // namespace cbvh::testbench
