// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <sstream>
#include <vector>

#include "rtl_model/bits/operations.h"
#include "rtl_model/kernel/clock.h"
#include "rtl_model/kernel/reg.h"
#include "rtl_model/kernel/stage_pipeline.h"
#include "rtl_model/kernel/vcd.h"
#include "tests/support/unit_run.h"

namespace cbvh::rtl {
namespace {

using testing::Disturbance;

constexpr UInt<9> add_one(UInt<8> value) { return value + UInt<1>(1); }
using Increment = StagePipeline<UInt<8>, UInt<9>, 4, add_one>;

std::vector<UInt<8>> counting(std::size_t count) {
  std::vector<UInt<8>> values;
  for (std::size_t i = 0; i < count; ++i) values.push_back(UInt<8>(i & 255));
  return values;
}

testing::Observed<UInt<9>> run_increment(const std::vector<UInt<8>>& values, const Disturbance& disturbance) {
  return testing::run_unit<UInt<8>, UInt<9>>(
      values, disturbance, [](auto& jobs, auto& results) { return std::make_unique<Increment>(jobs, results); });
}

TEST(Kernel, register_shows_the_old_value_until_the_clock_ticks) {
  Reg<int> reg(3);
  Clock clock(reg);
  reg.set(5);
  EXPECT_EQ(reg.q(), 3);
  clock.step();
  EXPECT_EQ(reg.q(), 5);
  clock.step();
  EXPECT_EQ(reg.q(), 5);
}

TEST(Kernel, channel_passes_a_value_a_cycle_and_never_sooner_than_the_next_cycle) {
  Channel<int> channel;
  Clock clock(channel);
  int next = 0;
  int expected = 0;
  for (int cycle = 0; cycle < 100; ++cycle) {
    if (channel.can_pop()) {
      EXPECT_EQ(channel.pop(), expected++);
    }
    ASSERT_TRUE(channel.can_push());
    channel.push(next++);
    clock.step();
  }
  EXPECT_EQ(expected, 99);
}

TEST(Kernel, channel_holds_two_values_and_then_refuses) {
  Channel<int> channel;
  Clock clock(channel);
  channel.push(1);
  clock.step();
  channel.push(2);
  clock.step();
  EXPECT_FALSE(channel.can_push());
  EXPECT_EQ(channel.pop(), 1);
  EXPECT_FALSE(channel.can_push()) << "ready must come from a register";
  clock.step();
  EXPECT_TRUE(channel.can_push());
  EXPECT_EQ(channel.pop(), 2);
}

TEST(Kernel, pipeline_has_its_latency_and_a_result_every_cycle) {
  const auto values = counting(300);
  const auto observed = run_increment(values, {});
  ASSERT_EQ(observed.responses.size(), values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    EXPECT_EQ(observed.responses[i].value(), values[i].value() + 1);
    EXPECT_EQ(observed.latencies()[i], 4u);
  }
}

TEST(Kernel, results_are_unchanged_when_source_and_sink_stall_and_the_order_is_shuffled) {
  const auto values = counting(500);
  const auto quiet = run_increment(values, {});
  for (const auto& disturbance : testing::stall_matrix()) {
    EXPECT_EQ(run_increment(values, disturbance).responses, quiet.responses);
  }
}

TEST(Kernel, shuffled_order_gives_the_same_trace_in_every_cycle) {
  const auto trace_of = [](bool shuffled) {
    Channel<UInt<8>> jobs;
    Channel<UInt<9>> between;
    Channel<UInt<9>> results;
    Increment first(jobs, between);
    StagePipeline<UInt<9>, UInt<9>, 2, [](UInt<9> value) { return value; }> second(between, results);
    Clock clock(first, second, jobs, between, results);
    SplitMix64 order(9);
    auto sink = StallPattern::bursts(4);
    std::ostringstream out;
    ValueChangeDump dump(out, "", 0, 1000);
    dump.add("jobs", jobs);
    dump.add("between", between);
    dump.add("results", results);
    for (std::uint64_t cycle = 0; cycle < 400; ++cycle) {
      if (jobs.can_push()) jobs.push(UInt<8>(cycle & 255));
      if (!sink.stalls() && results.can_pop()) results.pop();
      shuffled ? clock.step_shuffled(order) : clock.step();
      dump.sample(clock.cycle());
    }
    return out.str();
  };
  const auto ordered = trace_of(false);
  EXPECT_GT(ordered.size(), 4000u);
  EXPECT_EQ(trace_of(true), ordered);
}

TEST(Kernel, stall_pattern_both_stalls_and_lets_pass_and_repeats_with_its_seed) {
  auto one = StallPattern::bursts(5);
  auto other = StallPattern::bursts(5);
  int stalled = 0;
  for (int i = 0; i < 1000; ++i) {
    const bool stalls = one.stalls();
    EXPECT_EQ(stalls, other.stalls());
    stalled += stalls;
  }
  EXPECT_GT(stalled, 200);
  EXPECT_LT(stalled, 800);
}

}  // namespace
}  // namespace cbvh::rtl
