// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "golden/tree/compressed_tree.h"
#include "vectors/random.h"
#include "vectors/ray_steps.h"

/// Small trees in memory and rays through them.
namespace cbvh::vectors {

struct RayEpisode {
  golden::CompressedTree tree;
  std::vector<rtl::RayJob> rays;
  std::vector<RayHit> hits;
};

/// Lines in which the arrays of the traversal unit begin.
constexpr std::uint64_t kRayPairs = 0x40, kRayIds = 0x1000;

inline constexpr std::array<std::string_view, 16> kRayEpisodeClasses = {
    "single-leaf",   "single-pair", "left-spine", "right-spine", "balanced",  "random-shape",
    "big-leaves",    "same-boxes",  "planar",     "points",      "full-span", "axis-parallel",
    "origin-inside", "stops",       "deep-stack", "refused"};
RayEpisode make_ray_episode(std::size_t case_class, Random& random, int bits);

}  // namespace cbvh::vectors
