// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/sim/memory_map.h"

#include "golden/input_error.h"
#include "rtl_model/memory/line_port.h"

namespace cbvh::testbench {

std::uint64_t MemoryMap::add(const std::string& name, std::uint64_t bytes) {
  const std::uint64_t lines = (bytes + rtl::kBytesPerLine - 1) / rtl::kBytesPerLine;
  const std::uint64_t first = next_line_;
  next_line_ = (first + lines + row_lines_ - 1) / row_lines_ * row_lines_;
  if ((first + lines) * rtl::kBytesPerLine > capacity_bytes_) {
    throw golden::InputError("dram.capacity_bytes",
                             fmt::format("found {}, want {} or more: no room for {}", capacity_bytes_,
                                         (first + lines) * rtl::kBytesPerLine, name));
  }
  areas_.push_back({name, first, lines});
  return first;
}

}  // namespace cbvh::testbench
