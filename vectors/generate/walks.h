// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "vectors/faces/refit.h"
#include "vectors/random.h"

namespace cbvh::vectors {

/// A tree and its primitives in the order of the ID array.
struct PlainWalk {
  std::vector<rtl::TopologyPair> pairs;
  std::vector<WalkPrimitive> primitives;
  rtl::SceneRegisters registers;
};

inline constexpr std::array<std::string_view, 20> kWalkClasses = {
    "single-pair",     "left-spine",   "right-spine", "pending-spine",    "balanced",     "random-shape", "big-leaves",
    "adjacent-bounds", "wrong-child",  "wrong-leaf",  "flipped-leaf-bit", "ids-missing",  "unterminated", "more-ids",
    "open-nodes",      "out-of-range", "not-finite",  "too-deep",         "any-topology", "two-trees"};
/// One tree; of the last class one of two.
PlainWalk make_walk(std::size_t case_class, Random& random);
constexpr std::size_t kTwoWalksClass = kWalkClasses.size() - 1;

}  // namespace cbvh::vectors
