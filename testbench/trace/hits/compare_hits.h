// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "testbench/trace/compression.h"
#include "testbench/trace/hits/compare_hit.h"
#include "testbench/trace/hits/ray_sets.h"
#include "testbench/trace/picture.h"

namespace cbvh::testbench {

/// How many rays of each made set; those of a picture come before.
struct HitsJob {
  PictureJob picture;
  std::array<std::uint64_t, kRaySetNames.size()> rays = {1'000'000, 100'000, 100'000, 100'000};
  std::uint64_t seed = 1;
};

/// One set of rays.
struct HitsResult {
  std::string set;
  std::uint64_t rays = 0;
  std::array<std::uint64_t, kHitRelations> relations{};  ///< through the float tree
  std::uint64_t tree_differences = 0;                    ///< rays with another hit through the compressed tree
  std::vector<std::string> mistakes;                     ///< the first ones: ray, both hits
  std::uint64_t wrong() const;                           ///< rays that are our mistake
};

/// Every ray of every set through the float tree, the compressed tree and Embree with its robust flag. Throws
/// Unavailable in a build without Embree.
std::vector<HitsResult> compare_hits(const golden::Mesh& mesh, const TreePair& trees, const HitsJob& job);

}  // namespace cbvh::testbench
