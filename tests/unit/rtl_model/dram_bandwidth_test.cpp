// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "dram_bench.h"

/// How close to the data bus's peak the memory comes, and that nobody waits for ever.
namespace cbvh::rtl {
namespace {

using testing::DramBench;
using testing::read_request;
using testing::write_request;

constexpr std::uint64_t kLines = 20000;
constexpr std::uint64_t kElsewhere = 1 << 20;

TEST(DramBandwidth, sequential_reads_and_sequential_writes_reach_0_93_of_the_peak) {
  for (const bool write : {false, true}) {
    DramBench bench;
    for (std::uint64_t i = 0; i < kLines; ++i)
      bench.clients[0].requests.push_back(write ? write_request(i, 0) : read_request(i));
    ASSERT_TRUE(bench.run());
    EXPECT_LT(bench.times_bound(), 1 / 0.93) << (write ? "writes" : "reads");
    EXPECT_EQ(bench.dram.bound_cycles(), 5 * kLines);
  }
}

TEST(DramBandwidth, a_stream_of_reads_and_one_of_writes_reach_0_92_of_the_peak) {
  for (const bool one_port : {false, true}) {
    DramBench bench;
    for (std::uint64_t i = 0; i < kLines; ++i) {
      bench.clients[0].requests.push_back(read_request(i));
      bench.clients[one_port ? 0 : 1].requests.push_back(write_request(kElsewhere + i, 0));
    }
    ASSERT_TRUE(bench.run());
    EXPECT_LT(bench.times_bound(), 1 / 0.92) << (one_port ? "one port" : "two ports");
  }
}

/// Reads of `bytes` from one of 92 runs, at random, as a merge refills its buffers, and half as many writes.
double merge_times_bound(std::uint64_t bytes, std::size_t window) {
  DramBench bench;
  SplitMix64 random(5);
  std::vector<std::uint64_t> runs(92);
  for (std::size_t i = 0; i < runs.size(); ++i) runs[i] = i * 4096;
  for (std::uint64_t i = 0; i < kLines * 64 / bytes; ++i) {
    std::uint64_t& run = runs[random.below(runs.size())];
    for (std::uint64_t line = 0; line < bytes / 64; ++line) bench.clients[0].requests.push_back(read_request(run++));
  }
  for (std::uint64_t i = 0; i < kLines / 2; ++i) bench.clients[1].requests.push_back(write_request(kElsewhere + i, 0));
  bench.clients[0].window = window;
  EXPECT_TRUE(bench.run());
  return bench.times_bound();
}

TEST(DramBandwidth, a_merge_of_92_runs_in_pieces_of_128_bytes_stays_near_the_bound) {
  EXPECT_LT(merge_times_bound(128, 32), 1.18);
  EXPECT_LT(merge_times_bound(256, 32), 1.18);
}

TEST(DramBandwidth, four_streams_a_power_of_two_apart_come_as_close_to_the_peak_as_one) {
  for (const bool write : {false, true}) {
    DramBench bench;
    for (std::uint64_t i = 0; i < kLines; ++i) {
      const std::uint64_t line = i % 4 * kElsewhere + i / 4;
      bench.clients[i % 4].requests.push_back(write ? write_request(line, 0) : read_request(line));
    }
    ASSERT_TRUE(bench.run());
    EXPECT_LT(bench.times_bound(), 1 / 0.93) << (write ? "writes" : "reads");
  }
}

TEST(DramFairness, a_read_is_overtaken_by_no_more_hits_of_its_bank_than_allowed) {
  const auto longest_read = [](unsigned overtakes) {
    DramConfig config;
    config.channels = 1;
    config.overtakes = overtakes;
    DramBench bench(config);
    for (std::uint64_t i = 0; i < kLines; ++i) bench.clients[0].requests.push_back(read_request(i % 64));
    const DramAddressMap map(config);
    std::uint64_t rival = 512;
    while (map.place(rival).bank != map.place(0).bank) rival += 64;
    for (int i = 0; i < 50; ++i) bench.clients[1].requests.push_back(read_request(rival));
    bench.clients[1].window = 1;
    EXPECT_TRUE(bench.run());
    std::uint64_t longest = 0;
    for (std::size_t i = 1; i < 50; ++i)
      longest = std::max(longest, bench.clients[1].answer_cycles[i] - bench.clients[1].answer_cycles[i - 1]);
    return longest;
  };
  EXPECT_GT(longest_read(500), 3000u) << "hits go first";
  EXPECT_LT(longest_read(32), 1200u) << "48 older lines, 32 younger ones and a refresh take 1000 cycles";
}

TEST(DramFairness, reads_get_through_a_flood_of_writes_and_writes_through_a_flood_of_reads) {
  for (const bool flood_writes : {false, true}) {
    DramBench bench;
    for (std::size_t port = 0; port < 3; ++port) {
      for (std::uint64_t i = 0; i < kLines; ++i) {
        const std::uint64_t line = port * kElsewhere + i;
        bench.clients[port].requests.push_back(flood_writes ? write_request(line, 0) : read_request(line));
      }
    }
    for (std::uint64_t i = 0; i < 200; ++i) {
      const std::uint64_t line = 3 * kElsewhere + 97 * i;
      bench.clients[3].requests.push_back(flood_writes ? read_request(line) : write_request(line, 0, 0xFFFF, true));
    }
    bench.clients[3].window = 1;
    ASSERT_TRUE(bench.run());
    EXPECT_LT(bench.clients[3].answer_cycles.back(), 200u * 1600) << "a batch of the others takes 960";
    EXPECT_LT(bench.clients[3].answer_cycles.back(), bench.clients[0].answer_cycles.empty()
                                                         ? bench.dram.cycles() * 9 / 10
                                                         : bench.clients[0].answer_cycles.back() * 9 / 10);
  }
}

TEST(DramFairness, ports_that_ask_alike_are_served_alike) {
  for (const bool write : {false, true}) {
    DramBench bench;
    for (std::size_t port = 0; port < 4; ++port) {
      for (std::uint64_t i = 0; i < kLines / 2; ++i) {
        const std::uint64_t line = port * kElsewhere + i;
        bench.clients[port].requests.push_back(write ? write_request(line, 0) : read_request(line));
      }
    }
    while (bench.clients[0].sent < kLines / 4) bench.step();
    for (const auto& client : bench.clients) {
      EXPECT_GT(client.sent, kLines / 4 - 100);
      EXPECT_LT(client.sent, kLines / 4 + 100);
      EXPECT_LT(client.longest_wait, 500u);
    }
  }
}

TEST(DramFairness, a_write_to_a_line_that_three_ports_keep_reading_is_taken) {
  DramBench bench;
  for (std::size_t port = 0; port < 3; ++port) {
    for (std::uint64_t i = 0; i < kLines; ++i) bench.clients[port].requests.push_back(read_request(7));
  }
  for (std::uint64_t i = 0; i < 20; ++i)
    bench.clients[3].requests.push_back(write_request(7, static_cast<std::uint32_t>(i), 1, true));
  bench.clients[3].window = 1;
  ASSERT_TRUE(bench.run());
  EXPECT_LT(bench.clients[3].longest_wait, 2000u);
}

}  // namespace
}  // namespace cbvh::rtl
