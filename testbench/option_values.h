// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace cbvh::testbench {

// What several commands read from their options. Each throws InputError, whose place is the option.

/// The index of a word among the known ones.
std::size_t choice(const std::string& option, const std::string& found, const std::vector<std::string>& known);

void check_range(const std::string& option, int found, int low, int high);

/// e_min: an exponent -149..127, or nothing for "auto".
std::optional<int> parse_min_scale(const std::string& option, const std::string& text);

}  // namespace cbvh::testbench
