// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/backend/run_options.h"

#include <algorithm>

#include "golden/input_error.h"

namespace cbvh::testbench {

std::vector<std::string> stall_names() { return {"none", "source", "sink", "both"}; }

Stalls parse_stalls(const std::string& text) {
  const auto names = stall_names();
  const auto found = std::find(names.begin(), names.end(), text);
  if (found == names.end()) {
    throw golden::InputError("--stalls", fmt::format("unknown '{}', known: {}", text, fmt::join(names, ", ")));
  }
  return static_cast<Stalls>(found - names.begin());
}

std::string to_string(Stalls stalls) { return stall_names()[static_cast<std::size_t>(stalls)]; }

std::string mode_name(const RunOptions& options) {
  return to_string(options.stalls) + (options.shuffle ? " shuffled" : "");
}

}  // namespace cbvh::testbench
