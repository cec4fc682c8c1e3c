// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "vectors/line_payloads.h"
#include "vectors/random.h"

namespace cbvh::vectors {

using GatherStep = MemoryStep<GatherInput>;

/// Lines that the gatherer of this unit holds.
constexpr std::size_t kGathererLines = 8;

inline constexpr std::array<std::string_view, 9> kGatherClasses = {"single",    "in-two-lines", "neighbours",
                                                                   "backwards", "same-again",   "collisions",
                                                                   "scattered", "out-of-range", "two-arrays"};
std::vector<GatherStep> make_gather_steps(std::size_t case_class, Random& random);

}  // namespace cbvh::vectors
