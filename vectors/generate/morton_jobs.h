// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "vectors/lbvh_payloads.h"
#include "vectors/random.h"

namespace cbvh::vectors {

inline constexpr std::array<std::string_view, 9> kMortonClasses = {
    "scene-like",  "signed-zero",       "subnormal",   "largest-finite", "degenerate-axis",
    "cell-border", "outside-the-scene", "random-bits", "refused"};
/// Boxes of one scene; its bounds are finite.
std::vector<MortonJob> make_morton_jobs(std::size_t case_class, Random& random);

}  // namespace cbvh::vectors
