// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "rtl_model/lbvh/run_writer.h"

#include <gtest/gtest.h>

#include <map>
#include <vector>

#include "rtl_model/memory/ideal_line_memory.h"
#include "tests/support/unit_run.h"

namespace cbvh::rtl {
namespace {

using Memory = std::map<std::uint64_t, std::uint32_t>;  // words that were written

/// Runs of these lengths, one pass. Every word of a record is different.
std::vector<SortItem> items_of(const std::vector<std::size_t>& lengths) {
  std::vector<SortItem> items;
  for (const std::size_t length : lengths) {
    for (std::size_t i = 0; i < length; ++i) {
      const std::uint64_t base = 8 * items.size() + 1;
      SortItem item;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        item.record.box.lower[axis] = Float32::of_raw(0xA0000000 + base + axis);
        item.record.box.upper[axis] = Float32::of_raw(0xB0000000 + base + axis);
      }
      item.record.code = UInt<kMortonBits>(0x30000000 + base);
      item.record.id = Pointer(0x7000000 + base);
      item.last_of_run = UInt<1>(i + 1 == length);
      items.push_back(item);
    }
  }
  items.back().last = UInt<1>(1);
  return items;
}

struct Pass {
  RunArea area;
  std::vector<SortItem> items;
};

struct Outcome {
  std::vector<RunDescriptor> runs;
  Memory words;
  std::uint64_t writes = 0;
  bool operator==(const Outcome&) const = default;
};

/// From the formats: eight words a record, each run from the start of a line on.
Outcome expected(const std::vector<Pass>& passes) {
  Outcome outcome;
  for (const auto& [area, items] : passes) {
    std::uint64_t word = area.first_line.value() * 16;
    std::uint64_t first = word;
    for (const SortItem& item : items) {
      for (const auto& bounds : {item.record.box.lower, item.record.box.upper}) {
        for (const Float32 bound : bounds) outcome.words[word++] = bound.bits;
      }
      outcome.words[word++] = static_cast<std::uint32_t>(item.record.code.value());
      outcome.words[word++] = static_cast<std::uint32_t>(item.record.id.value());
      if (!item.last_of_run) continue;
      outcome.runs.push_back({LineAddress(first / 16), UInt<kPointerBits + 1>((word - first) / 8), item.last});
      outcome.writes += (word - first + 15) / 16;
      first = word = ((word + 15) / 16 + area.padding.value()) * 16;
    }
  }
  return outcome;
}

struct Observed {
  Outcome outcome;
  std::uint64_t cycles = 0;
  bool last_before_memory = false;  ///< a last run was told before everything was in memory
};

Observed run(const std::vector<Pass>& passes, const testing::Disturbance& disturbance, unsigned latency = 4) {
  Channel<RunArea> areas;
  Channel<SortItem> items;
  Channel<LineRequest> requests;
  Channel<LineData> answers;
  Channel<RunDescriptor> runs;
  RunWriter writer(areas, items, requests, answers, runs);
  IdealLineMemory memory({{&requests, &answers}}, 1 << 16, latency, disturbance.sink_stalls ? 9 : 0, disturbance.seed);
  Clock clock(areas, items, requests, answers, runs, writer, memory);
  SplitMix64 order(disturbance.seed);
  auto source = disturbance.source_stalls ? StallPattern::bursts(disturbance.seed + 1) : StallPattern::never();
  auto sink = disturbance.sink_stalls ? StallPattern::bursts(disturbance.seed + 2) : StallPattern::never();
  std::vector<SortItem> all;
  for (const Pass& pass : passes) all.insert(all.end(), pass.items.begin(), pass.items.end());
  const Outcome want = expected(passes);

  Observed observed;
  std::size_t next_area = 0;
  std::size_t next_item = 0;
  std::uint64_t lines_before = 0;
  while (observed.outcome.runs.size() < want.runs.size() && clock.cycle() < 100'000) {
    const bool offers = !source.stalls();
    if (offers && next_area < passes.size() && areas.can_push()) areas.push(passes[next_area++].area);
    if (offers && next_item < all.size() && items.can_push()) items.push(all[next_item++]);
    if (!sink.stalls() && runs.can_pop()) {
      observed.outcome.runs.push_back(runs.pop());
      lines_before += (observed.outcome.runs.back().records.value() + 1) / 2;
      if (observed.outcome.runs.back().last && memory.writes < lines_before) observed.last_before_memory = true;
    }
    disturbance.shuffled_order ? clock.step_shuffled(order) : clock.step();
  }
  observed.cycles = clock.cycle();
  observed.outcome.writes = memory.writes;
  for (std::uint64_t word = 0; word < (1 << 16); ++word) {
    if (memory.store.peek(word) != 0) observed.outcome.words[word] = memory.store.peek(word);
  }
  return observed;
}

Pass pass_of(std::uint64_t first_line, std::uint64_t padding, const std::vector<std::size_t>& lengths) {
  return {{LineAddress(first_line), LineAddress(padding)}, items_of(lengths)};
}

TEST(RunWriter, every_record_is_in_its_place_and_every_run_is_told_whatever_stalls) {
  const std::vector<Pass> passes = {pass_of(3, 0, {1}), pass_of(10, 0, {1, 2, 3, 4, 5, 1, 1, 1, 30}),
                                    pass_of(200, 5, {7, 1, 8, 2, 2}), pass_of(1000, 1, {64})};
  const Outcome want = expected(passes);
  ASSERT_EQ(want.runs.size(), 16U);
  for (const auto& disturbance : testing::stall_matrix()) {
    const Observed observed = run(passes, disturbance);
    ASSERT_EQ(observed.outcome.runs, want.runs);
    ASSERT_EQ(observed.outcome.words, want.words);
    ASSERT_EQ(observed.outcome.writes, want.writes) << "a line is written once";
  }
}

TEST(RunWriter, tells_the_last_run_of_a_pass_only_when_memory_has_it) {
  for (const unsigned latency : {1U, 4U, 100U}) {
    const Observed observed = run({pass_of(0, 0, {5, 3}), pass_of(50, 0, {2})}, {}, latency);
    EXPECT_EQ(observed.outcome.runs.size(), 3U);
    EXPECT_FALSE(observed.last_before_memory);
    EXPECT_GT(observed.cycles, 2 * latency + 10);
  }
}

TEST(RunWriter, takes_a_record_a_clock) {
  EXPECT_LT(run({pass_of(0, 0, {1000, 1001, 1, 1, 1, 1000})}, {}).cycles, 3004U + 16);
}

}  // namespace
}  // namespace cbvh::rtl
