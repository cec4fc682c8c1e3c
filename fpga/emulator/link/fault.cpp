// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "fpga/emulator/link/fault.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "golden/input_error.h"

namespace cbvh::emulator {

Fault parse_fault(const std::string& text) {
  const std::size_t colon = std::min(text.find(':'), text.size());
  const std::string name = text.substr(0, colon);
  const auto* const found = std::find(kFaultNames.begin(), kFaultNames.end(), name);
  if (found == kFaultNames.end()) {
    throw golden::InputError("--fault", fmt::format("found '{}', want one of {}", name, fmt::join(kFaultNames, ", ")));
  }
  Fault fault{static_cast<FaultKind>(found - kFaultNames.begin()), kUsualRate};
  if (colon == text.size()) return fault;
  const char* const end = text.data() + text.size();
  const auto [read, error] = std::from_chars(text.data() + colon + 1, end, fault.rate);
  if (error != std::errc() || read != end || !(fault.rate >= 0 && fault.rate <= 1)) {
    throw golden::InputError("--fault", fmt::format("rate: found '{}', want 0 to 1", text.substr(colon + 1)));
  }
  return fault;
}

}  // namespace cbvh::emulator
