// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "rtl_model/memory/dram_config.h"

#include <gtest/gtest.h>

#include <set>
#include <tuple>

#include "rtl_model/memory/dram_address.h"

namespace cbvh::rtl {
namespace {

TEST(DramConfig, default_is_consistent_and_the_papers_memory) {
  const DramConfig config;
  EXPECT_EQ(config.check(), std::nullopt);
  EXPECT_EQ(config.channels * 4 * 2 * config.timing.clock_mhz, 12800u) << "MB/s";
  EXPECT_EQ(config.rows(), 16384u) << "of a 4 Gb x32 die";
}

TEST(DramConfig, each_impossible_field_is_named_with_what_was_found_and_wanted) {
  const auto complaint = [](auto change) {
    DramConfig config;
    change(config);
    return config.check().value_or("nothing");
  };
  EXPECT_EQ(complaint([](auto& config) { config.channels = 0; }), "DRAM channels: 0, want a power of two from 1 to 8");
  EXPECT_EQ(complaint([](auto& config) { config.channels = 3; }), "DRAM channels: 3, want a power of two from 1 to 8");
  EXPECT_EQ(complaint([](auto& config) { config.banks = 7; }), "DRAM banks: 7, want a power of two from 1 to 32");
  EXPECT_EQ(complaint([](auto& config) { config.row_bytes = 32; }),
            "DRAM row_bytes: 32, want a power of two from 64 to 65536");
  EXPECT_EQ(complaint([](auto& config) { config.capacity_bytes = 1 << 15; }),
            "DRAM capacity_bytes: 32768, want a power of two from 65536 to 17179869184");
  EXPECT_EQ(complaint([](auto& config) { config.interleave_bytes = 8192; }),
            "DRAM interleave_bytes: 8192, want a power of two from 64 to 4096");
  EXPECT_EQ(complaint([](auto& config) { config.read_queue_depth = 0; }), "DRAM read_queue_depth: 0, want 1 to 64");
  EXPECT_EQ(complaint([](auto& config) { config.write_queue_depth = 65; }), "DRAM write_queue_depth: 65, want 1 to 64");
  EXPECT_EQ(complaint([](auto& config) { config.write_high = 65; }), "DRAM write_high: 65, want 1 to 64");
  EXPECT_EQ(complaint([](auto& config) { config.write_low = config.write_high; }),
            "DRAM write_low: " + std::to_string(DramConfig().write_high) + ", want 0 to " +
                std::to_string(DramConfig().write_high - 1));
  EXPECT_EQ(complaint([](auto& config) { config.core_clock_mhz = 0; }), "DRAM core_clock_mhz: 0, want 1 to 100000");
  EXPECT_EQ(complaint([](auto& config) { config.outstanding = 0; }), "DRAM outstanding: 0, want 1 to 4096");
  EXPECT_EQ(complaint([](auto& config) { config.timing.four_activates = 0; }), "DRAM tFAW: 0, want 1 to 100000");
}

TEST(DramAddress, no_two_lines_share_a_place_and_a_row_holds_consecutive_lines) {
  for (const bool hash : {false, true}) {
    for (const unsigned interleave_bytes : {64u, 256u, 4096u}) {
      DramConfig config;
      config.bank_hash = hash;
      config.interleave_bytes = interleave_bytes;
      config.capacity_bytes = 4 << 20;
      const DramAddressMap map(config);
      std::set<std::tuple<unsigned, unsigned, std::uint32_t, std::uint32_t>> places;
      const std::uint64_t lines = config.capacity_bytes / kBytesPerLine;
      for (std::uint64_t line = 0; line < lines; ++line) {
        const DramPlace place = map.place(line);
        EXPECT_EQ(place.channel, line / (interleave_bytes / kBytesPerLine) % 2);
        EXPECT_EQ(place.row, line / (1024));
        EXPECT_LT(place.bank, 8u);
        EXPECT_LT(place.column, 64u);
        places.insert({place.channel, place.bank, place.row, place.column});
      }
      EXPECT_EQ(places.size(), lines);
    }
  }
}

TEST(DramAddress, streams_a_power_of_two_apart_use_different_banks) {
  const DramAddressMap map{DramConfig()};
  for (int shift = 13; shift < 27; ++shift) {
    std::set<unsigned> banks;
    for (std::uint64_t stream = 0; stream < 8; ++stream) banks.insert(map.place((stream << shift) / 64).bank);
    EXPECT_EQ(banks.size(), 8u) << "streams 2^" << shift << " bytes apart";
  }
}

}  // namespace
}  // namespace cbvh::rtl
