// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "rtl_model/memory/dram.h"

#include <gtest/gtest.h>

#include <set>
#include <sstream>

#include "dram_bench.h"

namespace cbvh::rtl {
namespace {

using testing::DramBench;
using testing::random_requests;
using testing::read_request;
using testing::write_request;

/// Few lines, so that most requests meet others to the same line; then many.
std::unique_ptr<DramBench> run_random_ports(const DramConfig& config, const testing::Disturbance& disturbance,
                                            std::uint64_t lines) {
  auto bench = std::make_unique<DramBench>(config, disturbance);
  for (std::size_t i = 0; i < testing::kDramPorts; ++i)
    bench->clients[i].requests = random_requests(1500, lines, 77 + i, 20 + 20 * i);
  EXPECT_TRUE(bench->run());
  return bench;
}

TEST(Dram, every_read_returns_what_was_written_before_it_was_taken_under_every_stall) {
  std::size_t checks = 0;
  for (const std::uint64_t lines : {3u, 60u, 100000u}) {
    for (const auto& disturbance : testing::stall_matrix()) {
      const auto bench = run_random_ports({}, disturbance, lines);
      for (std::size_t i = 0; i < testing::kDramPorts; ++i) {
        ASSERT_EQ(bench->clients[i].answers, bench->expected[i]) << "port " << i << ", " << lines << " lines";
        checks += bench->expected[i].size();
      }
      for (const auto& [line, words] : bench->content) {
        for (std::size_t word = 0; word < kWordsPerLine; ++word)
          ASSERT_EQ(bench->dram.store.peek(line * kWordsPerLine + word), words[word].value());
      }
      EXPECT_EQ(bench->dram.error(), std::nullopt);
    }
  }
  EXPECT_GT(checks, 3u * 8 * 1500 * 2);
}

TEST(Dram, smallest_queues_and_odd_clocks_lose_nothing) {
  DramConfig config;
  config.channels = 1;
  config.banks = 1;
  config.row_bytes = 64;
  config.interleave_bytes = 64;
  config.capacity_bytes = 4096;
  config.read_queue_depth = config.write_queue_depth = config.write_high = config.batch_lines = 1;
  config.write_low = 0;
  config.outstanding = 1;
  for (const unsigned core_clock_mhz : {130u, 799u, 800u, 1601u}) {
    config.core_clock_mhz = core_clock_mhz;
    for (const DramRefresh refresh : {DramRefresh::all_banks, DramRefresh::per_bank}) {
      config.refresh = refresh;
      ASSERT_EQ(config.check(), std::nullopt);
      const auto bench = run_random_ports(config, {}, 64);
      for (std::size_t i = 0; i < testing::kDramPorts; ++i) ASSERT_EQ(bench->clients[i].answers, bench->expected[i]);
    }
  }
}

TEST(Dram, shuffled_order_changes_no_cycle) {
  const auto ordered = run_random_ports({}, {false, false, false, 5}, 1000);
  const auto shuffled = run_random_ports({}, {false, false, true, 5}, 1000);
  for (std::size_t i = 0; i < testing::kDramPorts; ++i)
    EXPECT_EQ(ordered->clients[i].answer_cycles, shuffled->clients[i].answer_cycles);
  EXPECT_EQ(ordered->dram.cycles(), shuffled->dram.cycles());
}

TEST(Dram, jitter_changes_timing_and_no_data) {
  const auto run_one_port = [](unsigned jitter) {
    DramConfig config;
    config.jitter = jitter;
    config.seed = 3;
    auto bench = std::make_unique<DramBench>(config);
    bench->clients[0].requests = random_requests(3000, 500, 9);
    EXPECT_TRUE(bench->run());
    return bench;
  };
  const auto quiet = run_one_port(0);
  const auto nervous = run_one_port(50);
  EXPECT_EQ(quiet->clients[0].answers, nervous->clients[0].answers);
  EXPECT_NE(quiet->clients[0].answer_cycles, nervous->clients[0].answer_cycles);
  EXPECT_GT(nervous->statistic("read_latency"), quiet->statistic("read_latency") + 10);
}

TEST(Dram, acknowledgement_comes_after_answer_latency_and_a_lone_read_after_its_row_is_open_at_any_clock_ratio) {
  for (const std::uint64_t core_clock_mhz : {200u, 799u, 800u, 1000u, 1333u}) {
    DramConfig config;
    config.core_clock_mhz = static_cast<unsigned>(core_clock_mhz);
    DramBench bench(config);
    bench.clients[0].requests = {write_request(5, 1, 0xFFFF, true)};
    bench.clients[1].requests = {read_request(100)};
    ASSERT_TRUE(bench.run());
    // Pushed in cycle 0, taken in 1 (two cycles into the run), ready 2 cycles later, seen one later.
    EXPECT_EQ(bench.clients[0].answer_cycles.at(0), 1u + 2 + 1);
    // Activate a clock after it was taken; then tRCD, and tCCD + RL + tDQSCK + BL/2 to the end of the second burst; the
    // cycle in which that is over; then as above.
    const std::uint64_t taken_clock = 1600 / core_clock_mhz;
    const std::uint64_t end_clock = taken_clock + 1 + 15 + 4 + 12 + 2 + 4;
    const std::uint64_t end_cycle = (end_clock * core_clock_mhz + 799) / 800;
    EXPECT_EQ(bench.clients[1].answer_cycles.at(0), end_cycle - 1 + 2 + 1) << core_clock_mhz << " MHz";
  }
}

TEST(Dram, access_beyond_the_capacity_is_reported_and_answered) {
  DramConfig config;
  config.capacity_bytes = 1 << 20;
  DramBench bench(config);
  bench.clients[2].requests = {read_request(16383), write_request(16384, 7), read_request(16385)};
  ASSERT_TRUE(bench.run());
  EXPECT_EQ(bench.dram.error(), "DRAM port 2 writes byte 1048576, capacity 1048576 bytes");
  EXPECT_EQ(bench.dram.store.out_of_range(), 16384u);
  EXPECT_EQ(bench.clients[2].answers.size(), 2u);
  EXPECT_EQ(bench.dram.counts().reads, 1u);
  EXPECT_EQ(bench.dram.counts().writes, 0u);
}

TEST(Dram, lost_answer_leaves_its_port_waiting) {
  DramConfig config;
  config.lose_answer = 5;
  DramBench bench(config);
  for (std::uint64_t i = 0; i < 20; ++i) bench.clients[0].requests.push_back(read_request(i));
  EXPECT_FALSE(bench.run(20000));
  EXPECT_EQ(bench.clients[0].answers.size(), 19u);
}

TEST(Dram, statistics_add_up) {
  DramBench bench;
  std::vector<DramAccess> accesses;
  bench.dram.hooks.on_access = [&](const DramAccess& access) { accesses.push_back(access); };
  std::size_t writes[4] = {};
  std::size_t reads[4] = {};
  for (std::size_t i = 0; i < 4; ++i) {
    bench.clients[i].requests = random_requests(2000, 3000, i);
    for (const LineRequest& request : bench.clients[i].requests) ++(request.write ? writes : reads)[i];
  }
  ASSERT_TRUE(bench.run());
  const auto of = [&](const char* name) { return static_cast<std::size_t>(bench.statistic(name)); };
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(of(("port_" + std::to_string(i) + "_reads").c_str()), reads[i]);
    EXPECT_EQ(of(("port_" + std::to_string(i) + "_writes").c_str()), writes[i]);
  }
  EXPECT_EQ(of("reads") + of("forwarded_reads"), reads[0] + reads[1] + reads[2] + reads[3]);
  EXPECT_EQ(of("writes") + of("merged_writes"), writes[0] + writes[1] + writes[2] + writes[3]);
  EXPECT_GT(of("forwarded_reads"), 0u);
  EXPECT_GT(of("merged_writes"), 0u);
  EXPECT_EQ(of("row_hits") + of("row_misses") + of("row_conflicts"), of("reads") + of("writes"));
  EXPECT_GE(of("activates"), of("row_misses") + of("row_conflicts"));
  EXPECT_EQ(of("busy_clocks"), 8 * (of("reads") + of("writes")));
  EXPECT_EQ(of("bytes_read"), 64 * of("reads"));
  EXPECT_EQ(of("bytes_written"), 64 * of("writes"));
  EXPECT_EQ(of("bound_cycles"), 5 * (of("reads") + of("writes"))) << "64 bytes at 12.8 GB/s and 1 GHz";
  EXPECT_EQ(accesses.size(), of("reads") + of("writes"));
  EXPECT_DOUBLE_EQ(bench.statistic("bandwidth"),
                   static_cast<double>(64 * accesses.size()) / static_cast<double>(bench.dram.cycles()));
  std::set<std::string> names;
  for (const DramStatistic& statistic : bench.dram.statistics()) {
    EXPECT_TRUE(names.insert(statistic.name).second) << statistic.name;
    EXPECT_FALSE(statistic.unit.empty() || statistic.description.empty()) << statistic.name;
  }
}

TEST(Dram, trace_is_ramulators_and_lists_each_line_once) {
  DramBench bench;
  std::ostringstream trace;
  bench.dram.hooks.on_access = [&](const DramAccess& access) { trace << dram_trace_line(access) << '\n'; };
  for (std::uint64_t i = 0; i < 300; ++i) bench.clients[0].requests.push_back(read_request(i * 977));
  for (std::uint64_t i = 0; i < 200; ++i) bench.clients[1].requests.push_back(write_request((1 << 23) + i * 31, 0));
  ASSERT_TRUE(bench.run());
  std::multiset<std::uint64_t> addresses[2];
  std::istringstream lines(trace.str());
  std::uint64_t address = 0;
  std::string kind;
  while (lines >> std::hex >> address >> kind) {
    ASSERT_TRUE(kind == "R" || kind == "W") << kind;
    addresses[kind == "W"].insert(address);
  }
  EXPECT_TRUE(lines.eof());
  std::multiset<std::uint64_t> wanted[2];
  for (std::uint64_t i = 0; i < 300; ++i) wanted[0].insert(i * 977 * 64);
  for (std::uint64_t i = 0; i < 200; ++i) wanted[1].insert(((1 << 23) + i * 31) * 64);
  EXPECT_EQ(addresses[0], wanted[0]);
  EXPECT_EQ(addresses[1], wanted[1]);
  EXPECT_EQ(trace.str().substr(0, 5), "0x0 R");
}

}  // namespace
}  // namespace cbvh::rtl
