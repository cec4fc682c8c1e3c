// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string_view>

#include "vectors/faces/ray.h"
#include "vectors/random.h"

namespace cbvh::vectors {

inline constexpr std::array<std::string_view, 24> kPairTestClasses = {
    "towards-box",   "axis-parallel",      "all-parallel",      "backwards", "origin-in-face",
    "origin-inside", "one-cell",           "tiny-direction",    "huge-box",  "far-apart",
    "power-of-two",  "subnormal-distance", "infinite-distance", "full-span", "minimum-scale-saturation",
    "same-children", "short-interval",     "not-finite",        "inverted",  "scale-below-minimum",
    "too-wide",      "several-reasons",    "any-codes",         "any-wires"};
PlainPairTest make_pair_test(std::size_t case_class, Random& random, int bits);

/// A ray at a pair of a real tree, as if its node were the root: `box` is the node's, `context` what the pair was
/// compressed with.
PlainPairTest pair_test_at(const golden::CompressedPair& pair, const golden::Context<std::int64_t>& context,
                           const golden::Box& box, const rtl::SceneRegisters& registers, Random& random, int bits);

}  // namespace cbvh::vectors
