// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "rtl_model/memory/dram_trace.h"

#include <array>
#include <cinttypes>
#include <cstdio>

namespace cbvh::rtl {

std::string dram_trace_line(const DramAccess& access) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "0x%" PRIx64 " %c", access.address, access.write ? 'W' : 'R');
  return text.data();
}

}  // namespace cbvh::rtl
