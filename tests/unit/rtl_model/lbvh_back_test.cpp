// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// The back of the LBVH builder as a whole: sorted runs in memory to a tree in memory.
#include <gtest/gtest.h>

#include "golden/build/lbvh.h"
#include "golden/tree/float_pair_format.h"
#include "rtl_model/lbvh/float_node_writer.h"
#include "rtl_model/lbvh/id_writer.h"
#include "rtl_model/lbvh/run_writer.h"
#include "tests/support/emit_run.h"
#include "tests/support/merge_run.h"
#include "tests/support/stalling_port.h"

namespace cbvh::rtl {
namespace {

using testing::Disturbance;
using testing::SortedRun;

constexpr std::uint64_t kRewritten = 1U << 16;
constexpr std::uint64_t kIds = 1U << 18;
constexpr std::uint64_t kPairs = 1U << 19;

/// The primitives dealt to runs of `length` as they come, each sorted.
std::vector<SortedRun> runs_of(std::vector<golden::CodedBox> sorted, std::size_t length) {
  std::sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) { return a.id < b.id; });
  std::vector<SortedRun> runs;
  for (std::size_t first = 0; first < sorted.size(); first += length) {
    const auto begin = sorted.begin() + static_cast<std::ptrdiff_t>(first);
    const auto end = begin + static_cast<std::ptrdiff_t>(std::min(length, sorted.size() - first));
    std::stable_sort(begin, end, [](const auto& a, const auto& b) { return a.code < b.code; });
    SortedRun& run = runs.emplace_back();
    for (auto item = begin; item != end; ++item) run.push_back(testing::sort_record(*item));
  }
  return runs;
}

/// Merger, emitter and the writers on one memory.
struct Back {
  Back(const MergeConfig& config, const Disturbance& disturbance, unsigned latency, unsigned jitter)
      : ports{StallingPort(disturbance, 0), StallingPort(disturbance, 1), StallingPort(disturbance, 2),
              StallingPort(disturbance, 3)},
        merger(runs, *near(0).requests, *near(0).answers, sorted, rewritten, config),
        rewriter(areas, rewritten, *near(1).requests, *near(1).answers, new_runs),
        emitter(sorted, jobs, ids, emitted, {}),
        id_writer(ids, *near(2).requests, *near(2).answers, ids_written, LineAddress(kIds)),
        node_writer(jobs, *near(3).requests, *near(3).answers, pairs_written, LineAddress(kPairs)),
        memory({ports[0].far(), ports[1].far(), ports[2].far(), ports[3].far()}, 1U << 20, latency, jitter,
               disturbance.seed) {}

  using StallingPort = testing::StallingPort;
  LinePort near(std::size_t port) { return ports[port].near(); }
  auto parts() {
    return std::tie(runs, new_runs, areas, sorted, rewritten, jobs, ids, emitted, ids_written, pairs_written, ports[0],
                    ports[1], ports[2], ports[3], merger, rewriter, emitter, id_writer, node_writer, memory);
  }

  Channel<RunDescriptor> runs, new_runs;
  Channel<RunArea> areas;
  Channel<SortItem> sorted, rewritten;
  Channel<StreamJob> jobs;
  Channel<IdEntry> ids;
  Channel<EmitReport> emitted;
  Channel<WriteReport> ids_written, pairs_written;
  StallingPort ports[4];
  RunMerger<MachineBits> merger;
  RunWriter rewriter;
  HierarchyEmitter<MachineBits> emitter;
  IdWriter id_writer;
  FloatNodeWriter node_writer;
  IdealLineMemory memory;
};

void expect_tree_in_memory(const LineStore& store, const golden::FloatTree& tree) {
  for (std::size_t i = 0; i < tree.primitive_ids.size(); ++i) {
    ASSERT_EQ(store.peek(kIds * kWordsPerLine + i), tree.primitive_ids[i]) << "entry " << i;
  }
  for (std::size_t i = 0; i < tree.pairs.size(); ++i) {
    const auto want = golden::pack_float_pair(tree.pairs[i]);
    for (std::size_t word = 0; word < want.size(); ++word) {
      ASSERT_EQ(store.peek((kPairs + i) * kWordsPerLine + word), want[word]) << "pair " << i;
    }
  }
}

/// Runs through the whole back; returns cycles.
std::uint64_t expect_scene(const std::string& scene, std::size_t run_length, const MergeConfig& config,
                           const Disturbance& disturbance = {}, unsigned latency = 4, unsigned jitter = 0) {
  const auto sorted = testing::sorted_boxes(scene);
  Back back(config, disturbance, latency, jitter);
  testing::RunStore store(back.memory.store);
  std::vector<RunDescriptor> descriptors;
  for (const SortedRun& run : runs_of(sorted, run_length)) {
    for (const auto& record : run) store.add(record);
    descriptors.push_back(store.end(false));
  }
  descriptors.back().last = UInt<1>(1);
  Clock clock(back);
  std::size_t sent = 0;
  std::size_t passes = 0;
  const bool finished = testing::run_until(clock, disturbance, 10000 + 200 * sorted.size(), [&] {
    if (sent < descriptors.size() && back.runs.can_push()) {
      back.runs.push(descriptors[sent++]);
    } else if (back.new_runs.can_pop() && back.runs.can_push()) {
      back.runs.push(back.new_runs.pop());
    }
    if (back.areas.can_push() && back.areas.pushes() == passes) {
      back.areas.push({LineAddress(kRewritten + (passes++ << 14)), {}});
    }
    return back.emitted.can_pop() && back.ids_written.can_pop() && back.pairs_written.can_pop();
  });
  EXPECT_TRUE(finished) << scene;
  expect_tree_in_memory(back.memory.store, golden::build_hierarchy(sorted));
  return clock.cycle();
}

TEST(LbvhBack, tree_of_a_scene_is_in_memory_bit_for_bit) {
  for (const std::string scene : {"proc:cloth", "proc:soup"}) {
    const auto cycles = expect_scene(scene, 8192, {}, {}, 40);
    EXPECT_LE(cycles, testing::sorted_boxes(scene).size() * 8 / 5) << "about 1.5 clocks a leaf";
  }
}

TEST(LbvhBack, tree_is_unchanged_by_stalls_slow_memory_and_several_passes) {
  constexpr MergeConfig kFourRuns{512, 4, 16, 8, 256};
  const std::string scene = "proc:cloth,sheet=24,height=20";
  for (const auto& disturbance : testing::stall_matrix()) {
    expect_scene(scene, 500, kFourRuns, disturbance, 4, 30);
    expect_scene(scene, 60, kFourRuns, disturbance, 20, 0);
  }
}

}  // namespace
}  // namespace cbvh::rtl
