// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cstdint>

#include "rtl_model/memory/dram_config.h"
#include "rtl_model/memory/line_port.h"

namespace cbvh::rtl {

/// Where a line is.
struct DramPlace {
  unsigned channel;
  unsigned bank;
  std::uint32_t row;
  std::uint32_t column;  ///< in lines

  bool operator==(const DramPlace&) const = default;
};

/// A line's number, from the top: row, bank, upper column, channel, lower column (the interleave).
class DramAddressMap {
 public:
  explicit DramAddressMap(const DramConfig& config)
      : interleave_bits_(bits(config.interleave_bytes / kBytesPerLine)),
        channel_bits_(bits(config.channels)),
        column_bits_(bits(config.row_bytes / kBytesPerLine)),
        bank_bits_(bits(config.banks)),
        bank_hash_(config.bank_hash && config.banks > 1) {}

  unsigned channel(std::uint64_t line) const {
    return static_cast<unsigned>(low(line >> interleave_bits_, channel_bits_));
  }
  DramPlace place(std::uint64_t line) const {
    const std::uint64_t block = line >> interleave_bits_;
    const std::uint64_t in_channel = block >> channel_bits_ << interleave_bits_ | low(line, interleave_bits_);
    const std::uint64_t in_bank = in_channel >> column_bits_;
    const std::uint64_t row = in_bank >> bank_bits_;
    std::uint64_t hash = 0;
    if (bank_hash_) {
      for (std::uint64_t left = row; left != 0; left >>= bank_bits_) hash ^= left;
    }
    return {channel(line), static_cast<unsigned>(low(in_bank ^ hash, bank_bits_)), static_cast<std::uint32_t>(row),
            static_cast<std::uint32_t>(low(in_channel, column_bits_))};
  }

 private:
  static int bits(std::uint64_t power_of_two) { return std::countr_zero(power_of_two); }
  static std::uint64_t low(std::uint64_t value, int bits) { return value & ((std::uint64_t{1} << bits) - 1); }

  int interleave_bits_;
  int channel_bits_;
  int column_bits_;
  int bank_bits_;
  bool bank_hash_;
};

}  // namespace cbvh::rtl
