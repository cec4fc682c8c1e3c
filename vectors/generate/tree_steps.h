// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "vectors/line_payloads.h"
#include "vectors/random.h"

/// Trees in memory, and the command to work on them.
namespace cbvh::vectors {

using RefitStep = MemoryStep<rtl::RefitCommand>;
using TopDownStep = MemoryStep<rtl::TopDownCommand>;

/// Lines in which the arrays of the refit unit begin.
constexpr std::uint64_t kRefitPairs = 0x40, kRefitIds = 0x400, kRefitPrimitives = 0x800;

inline constexpr std::array<std::string_view, 10> kRefitClasses = {
    "single-pair", "left-spine",    "right-spine", "balanced",     "random-shape",
    "big-leaves",  "negative-zero", "wrong-tree",  "out-of-range", "not-finite"};
std::vector<RefitStep> make_refit_steps(std::size_t case_class, Random& random);

/// Lines in which the arrays of the top-down compressor begin.
constexpr std::uint64_t kTopDownPairs = 0x40, kTopDownFloatPairs = 0x400;

inline constexpr std::array<std::string_view, 12> kTopDownClasses = {"single-pair",
                                                                     "left-spine",
                                                                     "right-spine",
                                                                     "pending-spine",
                                                                     "balanced",
                                                                     "random-shape",
                                                                     "longer-than-the-window",
                                                                     "refused",
                                                                     "wrong-pointer",
                                                                     "two-parents",
                                                                     "flipped-leaf-bit",
                                                                     "too-deep"};
std::vector<TopDownStep> make_top_down_steps(std::size_t case_class, Random& random);

}  // namespace cbvh::vectors
