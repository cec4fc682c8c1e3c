// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "vectors/lbvh_payloads.h"
#include "vectors/random.h"

namespace cbvh::vectors {

inline constexpr std::array<std::string_view, 11> kSortClasses = {
    "random",        "equal-codes", "few-codes",     "ascending",        "descending",
    "nearly-sorted", "saw-tooth",   "single-record", "exactly-capacity", "one-more-than-capacity",
    "several-scenes"};
/// Records for a sorter with a scratchpad of `capacity` records; scenes end with a record marked last.
std::vector<rtl::SortItem> make_sort_items(std::size_t case_class, Random& random, std::size_t capacity);

inline constexpr std::array<std::string_view, 7> kRunClasses = {
    "single-record", "one-run", "runs-of-one", "even-runs", "any-runs", "padded-runs", "several-passes"};
/// Runs for the run writer, in one pass or several.
std::vector<RunStep> make_run_steps(std::size_t case_class, Random& random);

}  // namespace cbvh::vectors
