// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "testbench/eval/space/trees.h"

namespace cbvh::testbench {

/// What a random ray costs on average.
struct MeanRay {
  double traversal = 0;     ///< inner nodes visited
  double intersection = 0;  ///< triangles tested
  double cost() const { return kSpaceTraversal * traversal + kSpaceIntersection * intersection; }
};

struct SpaceMeasure {
  std::string scene;
  std::string tree;     ///< its name
  std::string builder;  ///< as it was built
  double overlap = 0;   ///< C_O, of a tree of the overlap curve
  std::uint64_t triangles = 0;
  std::uint64_t references = 0;
  std::uint64_t bytes = 0;  ///< of float node pairs, 64 each, and references, 4 each
  int depth = 0;
  double build_seconds = 0;
  double expected = 0;  ///< Exp(T), with the paper's costs
  MeanRay terminating;
  MeanRay through;
  std::uint64_t checks = 0;
  std::vector<std::string> failures;
};

struct SpaceJob {
  std::vector<std::string> scenes;
  std::vector<std::string> builders;  ///< in place of the paper's trees, if there are any; the first is compared with
  std::vector<double> penalties = {0, 1, 10, 100, 1000, 1e16};
  std::uint64_t rays = 100000;
  std::uint64_t covered = 32;  ///< triangles a tree whose coverage is checked
  unsigned threads = 0;
};

struct SpaceMeasures {
  std::vector<SpaceMeasure> trees;
  std::vector<SpaceMeasure> overlap;  ///< of G-BVH, for each penalty
};

/// Measures every tree of every scene, scene by scene. Checked of each: check_tree; the leaves' boxes cover triangles
/// taken at regular distances, exactly; every ray's nearest hit is that of the first tree. Throws InputError for what
/// cannot be read, before anything is measured, and for a scene whose box has no volume: rays need one.
SpaceMeasures measure_space(const SpaceJob& job);

}  // namespace cbvh::testbench
