// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

namespace cbvh::rtl {

/// What a channel has done.
struct DramCounts {
  std::uint64_t reads = 0;  ///< lines, on the pins
  std::uint64_t writes = 0;
  std::uint64_t row_hits = 0;
  std::uint64_t row_misses = 0;
  std::uint64_t row_conflicts = 0;
  std::uint64_t activates = 0;
  std::uint64_t precharges = 0;
  std::uint64_t refreshes = 0;
  std::uint64_t turnarounds = 0;

  DramCounts& operator+=(const DramCounts& other);
};

/// What one port has been given.
struct DramPortCounts {
  std::uint64_t reads = 0;  ///< lines taken
  std::uint64_t writes = 0;
  std::uint64_t read_cycles = 0;  ///< from taking each read to its answer, added up
};

/// A row of the table of statistics.
struct DramStatistic {
  std::string name;
  std::string unit;
  std::string description;
  double value;
};

}  // namespace cbvh::rtl
