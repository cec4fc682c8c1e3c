// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// How fast the parts of a refit are, alone; what they give is tested by the vectors of their units.
#include <gtest/gtest.h>

#include "rtl_model/refit/id_reader.h"
#include "rtl_model/refit/primitive_gatherer.h"
#include "rtl_model/refit/refit_walker.h"
#include "rtl_model/refit/tree_reader.h"
#include "tests/support/stalling_port.h"

namespace cbvh::rtl {
namespace {

using testing::StallingPort;

struct Times {
  std::uint64_t first = 0;  ///< from when the unit was told to when its first item could be taken
  std::uint64_t last = 0;
  std::size_t items = 0;
};

/// Reads an array through memory that answers after `latency`.
template <class Reader, class Item>
Times read(std::uint64_t items, unsigned latency, std::size_t outstanding) {
  Channel<ReadCommand> commands;
  Channel<LineRequest> requests;
  Channel<LineData> answers;
  Channel<Item> read_items;
  Reader reader(commands, {&requests, &answers}, read_items, outstanding);
  IdealLineMemory memory({{&requests, &answers}}, 10000, latency);
  Clock clock(reader, memory, commands, requests, answers, read_items);
  commands.push({LineAddress(7), ItemCount(items)});
  clock.step();
  const std::uint64_t taken = clock.cycle();
  Times times;
  while (times.items < items && clock.cycle() < 100000) {
    if (read_items.can_pop()) {
      if (times.items++ == 0) times.first = clock.cycle() - taken;
      times.last = clock.cycle() - taken;
      EXPECT_EQ(bool(read_items.pop().last), times.items == items);
    }
    clock.step();
  }
  return times;
}

TEST(RefitParts, readers_give_an_item_a_clock_after_three_clocks_and_the_latency_of_memory) {
  for (const unsigned latency : {2u, 4u, 20u, 50u}) {
    const auto pairs = read<TreeReader, TopologyPair>(1000, latency, 16);
    EXPECT_EQ(pairs.first, latency + 3);
    EXPECT_EQ(pairs.last, pairs.first + 999);
    const auto ids = read<IdReader, IdEntry>(1000, latency, 16);
    EXPECT_EQ(ids.first, latency + 3);
    EXPECT_EQ(ids.last, ids.first + 999);
  }
}

TEST(RefitParts, a_reader_with_few_reads_in_flight_is_as_fast_as_they_are_answered) {
  const auto pairs = read<TreeReader, TopologyPair>(400, 40, 2);
  EXPECT_GT(pairs.last, 100 / 2 * 40u);
  EXPECT_LT(pairs.last, 100 / 2 * 46u);
}

TEST(RefitParts, the_gatherer_hides_the_latency_of_memory_and_takes_one_and_a_half_clocks_a_primitive) {
  for (const unsigned latency : {2u, 4u, 14u}) {
    Channel<ReadCommand> commands;
    Channel<IdEntry> ids;
    Channel<LineRequest> requests;
    Channel<LineData> answers;
    Channel<Primitive> primitives;
    Channel<LeafMark> marks;
    PrimitiveGatherer<MachineBits> gatherer(commands, ids, {&requests, &answers}, primitives, marks);
    IdealLineMemory memory({{&requests, &answers}}, 10000, latency);
    Clock clock(gatherer, memory, commands, ids, requests, answers, primitives, marks);
    constexpr std::uint64_t kIds = 4000;
    commands.push({LineAddress(7), ItemCount(kIds)});
    clock.step();
    clock.step();
    std::uint64_t sent = 0, given = 0, first = 0;
    const std::uint64_t begin = clock.cycle();
    while (given < kIds && clock.cycle() < 100000) {
      if (sent < kIds && ids.can_push()) {  // far apart: nothing is shared but lines of one primitive
        const std::uint64_t id = sent * 2011 % kIds;
        ids.push({Pointer(id), UInt<1>(1), UInt<1>(++sent == kIds)});
      }
      if (primitives.can_pop()) {
        if (given++ == 0) first = clock.cycle() - begin;
        primitives.pop();
        marks.pop();
      }
      clock.step();
    }
    ASSERT_EQ(given, kIds);
    EXPECT_EQ(first, 1 + latency + 2);  // a clock in the channel of IDs
    EXPECT_EQ(gatherer.lines_read + gatherer.lines_shared, kIds * 3 / 2);
    EXPECT_LE(clock.cycle() - begin, kIds * 3 / 2 + latency + 8);
  }
}

TEST(RefitParts, the_walker_takes_one_and_a_half_clocks_a_pair_of_a_balanced_tree) {
  constexpr std::size_t kLeaves = 1024;
  std::vector<TopologyPair> pairs;
  const auto build = [&](auto&& self, std::size_t begin, std::size_t end) -> std::pair<bool, std::size_t> {
    if (end - begin == 1) return {true, begin};
    const auto left = self(self, begin, (begin + end) / 2);
    const auto right = self(self, (begin + end) / 2, end);
    pairs.push_back({{UInt<1>(left.first), UInt<1>(right.first)}, {Pointer(left.second), Pointer(right.second)}, {}});
    return {false, pairs.size() - 1};
  };
  build(build, 0, kLeaves);
  pairs.back().last = UInt<1>(1);
  Channel<SceneRegisters> starts;
  Channel<TopologyPair> topology;
  Channel<PrimitiveBox> boxes;
  Channel<LeafMark> marks;
  Channel<StreamJob> jobs;
  Channel<WalkReport> reports;
  RefitWalker<MachineBits> walker(starts, topology, boxes, marks, jobs, reports);
  Clock clock(walker, starts, topology, boxes, marks, jobs, reports);
  starts.push({});
  std::size_t sent_pairs = 0, sent_boxes = 0, given = 0;
  while (!reports.can_pop() && clock.cycle() < 10000) {
    if (sent_pairs < pairs.size() && topology.can_push()) topology.push(pairs[sent_pairs++]);
    if (sent_boxes < kLeaves && boxes.can_push() && marks.can_push()) {
      const UInt<1> last(++sent_boxes == kLeaves);
      boxes.push({{}, {}, last, {}});
      marks.push({UInt<1>(1), last, UInt<1>(1)});
    }
    if (jobs.can_pop()) {
      jobs.pop();
      ++given;
    }
    clock.step();
  }
  ASSERT_TRUE(reports.can_pop());
  EXPECT_EQ(reports.front(), WalkReport());
  EXPECT_EQ(given, kLeaves - 1);
  EXPECT_LE(clock.cycle(), kLeaves * 3 / 2 + 16);
}

}  // namespace
}  // namespace cbvh::rtl
