// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "vectors/line_payloads.h"
#include "vectors/random.h"

namespace cbvh::vectors {

using ArrayStep = MemoryStep<rtl::ReadCommand>;

rtl::LineWords random_line(Random& random);

inline constexpr std::array<std::string_view, 7> kArrayClasses = {
    "single-item", "part-of-a-line", "whole-lines", "many-lines", "two-arrays", "all-ones", "past-the-reads-in-flight"};
/// Arrays of items, so many to a line, and the commands to read them.
std::vector<ArrayStep> make_array_steps(std::size_t case_class, std::uint64_t items_per_line, Random& random);

}  // namespace cbvh::vectors
