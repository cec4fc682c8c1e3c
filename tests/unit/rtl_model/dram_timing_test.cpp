// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "rtl_model/memory/dram_timing.h"

#include <gtest/gtest.h>

#include <string_view>

#include "dram_bench.h"
#include "dram_command_checker.h"

namespace cbvh::rtl {
namespace {

using testing::DramBench;
using testing::DramCommandChecker;

/// Rows hit, missed and in conflict, reads and writes close together.
DramCommandChecker watch_random_traffic(const DramConfig& config, std::size_t requests = 6000) {
  DramCommandChecker checker(config.banks);
  DramBench bench(config);
  bench.dram.hooks.on_command = std::ref(checker);
  bench.clients[0].requests = testing::random_requests(requests, 4000, 1, 30);
  bench.clients[1].requests = testing::random_requests(requests, 1 << 20, 2, 10);
  bench.clients[2].requests = testing::random_requests(requests, 100, 3, 60);
  bench.clients[2].window = 2;
  for (std::size_t i = 0; i < requests; ++i) bench.clients[3].requests.push_back(testing::read_request(i));
  EXPECT_TRUE(bench.run());
  EXPECT_EQ(bench.dram.counts().activates, checker.counts[DramCommandKind::activate]);
  EXPECT_EQ(2 * bench.dram.counts().reads, checker.counts[DramCommandKind::read]);
  EXPECT_EQ(2 * bench.dram.counts().writes, checker.counts[DramCommandKind::write]);
  EXPECT_EQ(bench.dram.counts().turnarounds, checker.turnarounds);
  EXPECT_EQ(bench.dram.counts().precharges,
            checker.counts[DramCommandKind::precharge] + checker.counts[DramCommandKind::precharge_all]);
  EXPECT_EQ(bench.dram.counts().refreshes,
            checker.counts[DramCommandKind::refresh] + checker.counts[DramCommandKind::refresh_bank]);
  return checker;
}

TEST(DramTiming, no_command_comes_before_the_standard_allows_it) {
  for (const DramRefresh refresh : {DramRefresh::all_banks, DramRefresh::per_bank}) {
    for (const unsigned interleave_bytes : {64u, 4096u}) {
      DramConfig config;
      config.refresh = refresh;
      config.interleave_bytes = interleave_bytes;
      const DramCommandChecker checker = watch_random_traffic(config);
      EXPECT_EQ(checker.first_violation, "");
      EXPECT_GT(checker.checks, 200000u);
    }
  }
}

TEST(DramTiming, every_constraint_is_met_to_the_clock) {
  const DramCommandChecker checker = watch_random_traffic({});
  for (const char* rule : {"command bus", "tRPpb", "tRFCab", "tRRD", "tFAW", "tRAS", "tRTP", "tWR", "tCCD of reads",
                           "tCCD of writes", "tWTR", "read to write", "tRCD", "tRPab to refresh"}) {
    ASSERT_EQ(checker.closest.count(rule), 1u) << rule;
    EXPECT_EQ(checker.closest.at(rule), 0) << rule;
  }
}

TEST(DramTiming, checker_sees_each_constraint_that_is_broken_by_one_clock) {
  std::size_t broken = 0;
  for (const DramTimingEntry& entry : kLpddr3Timing) {
    const std::string_view name = entry.name;
    if (name == "fCK" || name == "tRC") continue;  // tRAS + tRPpb is longer than tRC
    DramConfig config;
    config.refresh = name == "tRFCpb" ? DramRefresh::per_bank : DramRefresh::all_banks;
    config.timing.*entry.value += name == "tREFI" ? 200u : ~0u;
    EXPECT_NE(watch_random_traffic(config).first_violation, "") << name;
    ++broken;
  }
  EXPECT_EQ(broken, 17u);
}

TEST(DramTiming, every_line_moves_to_or_from_the_row_of_its_address) {
  DramConfig config;
  config.bank_hash = false;
  config.interleave_bytes = 64;
  DramBench bench(config);
  DramCommandChecker checker;
  std::size_t checks = 0;
  std::uint64_t line = 0;
  bool announced = false;
  bench.dram.hooks.on_access = [&](const DramAccess& access) {
    line = access.address / 64;
    announced = true;
  };
  bench.dram.hooks.on_command = [&](const DramCommand& command) {
    checker(command);
    if (!announced) return;
    announced = false;
    EXPECT_EQ(command.channel, line % 2);
    EXPECT_EQ(command.bank, line / 2 / 64 % 8);
    EXPECT_EQ(command.row, line / 2 / 64 / 8);
    ++checks;
  };
  for (std::size_t i = 0; i < testing::kDramPorts; ++i)
    bench.clients[i].requests = testing::random_requests(3000, std::uint64_t{1000} << 4 * i, i);
  ASSERT_TRUE(bench.run());
  EXPECT_EQ(checker.first_violation, "");
  EXPECT_EQ(checks, bench.dram.counts().reads + bench.dram.counts().writes);
}

TEST(DramTiming, refreshes_go_on_when_nothing_is_asked) {
  for (const DramRefresh refresh : {DramRefresh::all_banks, DramRefresh::per_bank}) {
    DramConfig config;
    config.refresh = refresh;
    DramCommandChecker checker;
    DramBench bench(config);
    bench.dram.hooks.on_command = std::ref(checker);
    bench.clients[0].requests = {testing::read_request(0)};
    for (int i = 0; i < 100 * 3900; ++i) bench.step();
    EXPECT_EQ(checker.first_violation, "");
    EXPECT_EQ(bench.dram.counts().refreshes, refresh == DramRefresh::per_bank ? 2u * 8 * 100 : 2u * 100);
  }
}

}  // namespace
}  // namespace cbvh::rtl
