// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/option_values.h"

#include <fmt/format.h>

#include "golden/input_error.h"

namespace cbvh::testbench {

std::size_t choice(const std::string& option, const std::string& found, const std::vector<std::string>& known) {
  for (std::size_t i = 0; i < known.size(); ++i) {
    if (known[i] == found) return i;
  }
  throw golden::InputError(option, fmt::format("unknown '{}', known: {}", found, fmt::join(known, ", ")));
}

void check_range(const std::string& option, int found, int low, int high) {
  if (found < low || found > high)
    throw golden::InputError(option, fmt::format("found {}, want {}..{}", found, low, high));
}

std::optional<int> parse_min_scale(const std::string& option, const std::string& text) {
  if (text == "auto") return std::nullopt;
  std::size_t used = 0;
  int value = 0;
  try {
    value = std::stoi(text, &used);
  } catch (const std::exception&) {
    used = 0;
  }
  if (used != text.size() || text.empty())
    throw golden::InputError(option, fmt::format("found '{}', want auto or an integer", text));
  check_range(option, value, -149, 127);
  return value;
}

}  // namespace cbvh::testbench
