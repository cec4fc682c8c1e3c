// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace cbvh::testbench {

/// An area of the simulated memory.
struct MemoryArea {
  std::string name;
  std::uint64_t first_line = 0;
  std::uint64_t lines = 0;
};

/// Areas one after the other, each beginning with a row of all channels.
class MemoryMap {
 public:
  /// `row_lines` is the alignment; areas end at `capacity_bytes`.
  MemoryMap(std::uint64_t row_lines, std::uint64_t capacity_bytes)
      : row_lines_(row_lines), capacity_bytes_(capacity_bytes) {}

  /// The first line of a new area. Throws InputError naming it when the memory is too small.
  std::uint64_t add(const std::string& name, std::uint64_t bytes);

  const std::vector<MemoryArea>& areas() const { return areas_; }

 private:
  std::uint64_t row_lines_;
  std::uint64_t capacity_bytes_;
  std::uint64_t next_line_ = 0;
  std::vector<MemoryArea> areas_;
};

}  // namespace cbvh::testbench
