// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "rtl_model/datapath/lbvh_payloads.h"
#include "vectors/random.h"

namespace cbvh::vectors {

inline constexpr std::array<std::string_view, 14> kMergeClasses = {
    "single-record",       "one-run",     "equal-codes",    "few-codes",         "ends-of-the-curve",
    "one-after-the-other", "in-reverse",  "as-many-as-fit", "one-more-than-fit", "two-passes",
    "three-passes",        "runs-of-one", "one-long-run",   "any-runs"};
/// Sorted runs for a merger of `most_runs` runs: all records, run after run.
std::vector<rtl::SortItem> make_sorted_runs(std::size_t case_class, Random& random, std::size_t most_runs);

}  // namespace cbvh::vectors
