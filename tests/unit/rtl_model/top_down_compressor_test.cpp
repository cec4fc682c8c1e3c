// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "rtl_model/compress/top_down_compressor.h"

#include <gtest/gtest.h>

#include "golden/build/lbvh.h"
#include "golden/quantize/scale.h"
#include "golden/scene/load.h"
#include "golden/scene/trouble_scenes.h"
#include "golden/update/top_down.h"
#include "tests/support/scene_memory.h"
#include "tests/support/stalling_port.h"
#include "vectors/convert.h"

namespace cbvh::rtl {
namespace {

using golden::Code;
using testing::Disturbance;
using testing::StallingPort;

constexpr std::uint64_t kPairs = 0, kFloatPairs = 20000;

struct Run {
  bool finished = false;
  StreamReport report;
  std::vector<golden::CompressedPair> pairs;
  std::uint64_t cycles = 0;
  std::uint64_t reads = 0;
  std::uint64_t writes = 0;
};

golden::GridRules rules_of(const golden::FloatTree& tree, int bits) {
  return {bits, golden::exactness_limit(tree.largest_magnitude), golden::ScaleRule::equation2};
}

template <int N>
Run compress(const golden::FloatTree& tree, Code code, const Disturbance& disturbance = {}, unsigned latency = 8,
             unsigned jitter = 0) {
  Channel<TopDownCommand> commands;
  Channel<StreamReport> reports;
  StallingPort reads(disturbance, 0), writes(disturbance, 1);
  TopDownCompressor<MachineBits, N> unit(commands, reads.near(), writes.near(), reports,
                                         {LineAddress(kFloatPairs), LineAddress(kPairs)});
  IdealLineMemory memory({reads.far(), writes.far()}, 100000, latency, jitter, disturbance.seed);
  testing::poke_float_pairs(memory.store, kFloatPairs, tree.pairs);
  Clock clock(unit, reads, writes, memory, commands, reports);
  commands.push({ItemCount(tree.pairs.size()), vectors::scene_registers(rules_of(tree, N), code)});
  Run run;
  run.finished =
      testing::run_until(clock, disturbance, 10000 + 500 * tree.pairs.size(), [&] { return reports.can_pop(); });
  if (!run.finished) return run;
  run.report = reports.front();
  run.cycles = clock.cycle();
  run.pairs = testing::peek_pairs(memory.store, kPairs, tree.pairs.size());
  run.reads = memory.reads;
  run.writes = memory.writes;
  return run;
}

template <int N>
void expect_top_down(const golden::FloatTree& tree, Code code, const Disturbance& disturbance = {},
                     unsigned latency = 8, unsigned jitter = 0) {
  const auto wanted = golden::compress_top_down(tree, rules_of(tree, N), code);
  const auto run = compress<N>(tree, code, disturbance, latency, jitter);
  ASSERT_TRUE(run.finished);
  EXPECT_EQ(run.report, (StreamReport{Pointer(tree.pairs.size() - 1), {}, vectors::context(wanted.root), {}}));
  EXPECT_TRUE(run.pairs == wanted.pairs);
  EXPECT_EQ(run.reads, tree.pairs.size());
  EXPECT_EQ(run.writes, (tree.pairs.size() + 3) / 4);
}

golden::FloatTree tree_of(const std::string& scene) { return golden::build_lbvh(golden::load_scene(scene)); }

TEST(TopDownCompressor, memory_equals_the_golden_top_down_tree_with_a_read_a_pair_and_a_write_a_line) {
  for (const char* scene : {"proc:cloth,sheet=30,height=20", "proc:terrain,triangles=3000", "proc:city,triangles=3000",
                            "proc:hairball,triangles=3000"}) {
    const auto tree = tree_of(scene);
    for (const auto code : {Code::modulo, Code::relative}) {
      expect_top_down<6>(tree, code);
      expect_top_down<2>(tree, code);
    }
  }
  std::size_t trees = 0;
  for (std::uint64_t id = 0; id < 240; ++id) {
    const auto mesh = golden::trouble_scene(golden::kTroubles[id % golden::kTroubles.size()], id, 60);
    const auto tree = golden::build_lbvh(mesh);
    if (tree.pairs.empty()) continue;
    expect_top_down<6>(tree, id % 2 == 0 ? Code::modulo : Code::relative, {}, 1 + static_cast<unsigned>(id % 30));
    ASSERT_FALSE(::testing::Test::HasFailure()) << mesh.name;
    ++trees;
  }
  EXPECT_GT(trees, 150u);
}

TEST(TopDownCompressor, result_is_unchanged_by_stalls_jitter_and_order_of_evaluation) {
  const auto tree = tree_of("proc:cloth,sheet=12,height=12");
  for (const auto& disturbance : testing::stall_matrix()) {
    for (const unsigned latency : {1u, 20u, 90u}) {
      expect_top_down<6>(tree, Code::relative, disturbance, latency, latency / 2);
      ASSERT_FALSE(::testing::Test::HasFailure());
    }
  }
}

TEST(TopDownCompressor, waiting_for_contexts_costs_less_than_the_memory_of_the_paper) {
  // 80 bytes a pair at 12.8 bytes a clock are 6.25 clocks.
  for (const char* scene : {"proc:cloth", "proc:terrain,triangles=20000"}) {
    const auto tree = tree_of(scene);
    const auto run = compress<6>(tree, Code::modulo);
    ASSERT_TRUE(run.finished);
    const double clocks = static_cast<double>(run.cycles) / static_cast<double>(tree.pairs.size());
    RecordProperty(scene, std::to_string(clocks));
    EXPECT_LE(clocks, 2.0);
  }
}

/// A tree of `levels` pairs one below the other.
golden::FloatTree spine(std::size_t levels, std::size_t inner_child) {
  golden::FloatTree tree;
  for (std::uint32_t i = 0; i < levels; ++i) {
    const float size = std::ldexp(1.0F, static_cast<int>(i) - 12);
    const golden::Box small{glm::vec3(0), glm::vec3(size)}, beside{glm::vec3(size), glm::vec3(2 * size)};
    golden::FloatPair pair{{small, beside}, {true, true}, {i, i}};
    if (inner_child == 1) std::swap(pair.child[0], pair.child[1]);
    if (i > 0) pair.leaf[inner_child] = false;
    if (i > 0) pair.pointer[inner_child] = i - 1;
    tree.pairs.push_back(pair);
  }
  tree.scene = golden::own_box(tree.pairs.back());
  tree.largest_magnitude = golden::largest_magnitude(tree.scene);
  return tree;
}

TEST(TopDownCompressor, a_spine_takes_the_compressors_latency_and_a_clock_a_pair_and_a_single_pair_works) {
  for (const std::size_t child : {0u, 1u}) {
    expect_top_down<6>(spine(1, child), Code::modulo);
    expect_top_down<6>(spine(30, child), Code::relative);
    EXPECT_EQ(compress<6>(spine(24, child), Code::modulo).cycles,
              compress<6>(spine(4, child), Code::modulo).cycles + 20 * 7);
  }
}

StreamReport refused(Status status, std::uint64_t index) {
  return {Pointer(index), {}, {}, StatusBits(static_cast<std::uint64_t>(status))};
}

TEST(TopDownCompressor, a_bad_tree_ends_with_its_first_bad_pair_from_the_root_whatever_stalls) {
  const auto valid = tree_of("proc:cloth,sheet=12,height=12");
  const auto size = valid.pairs.size();
  for (const auto& disturbance : testing::stall_matrix()) {
    auto tree = valid;
    tree.pairs[40].child[1].upper.y = std::numeric_limits<float>::infinity();
    tree.pairs[300].child[0].lower.y = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(compress<6>(tree, Code::modulo, disturbance, 9, 5).report, refused(Status::not_finite, 300));
    tree = valid;
    tree.pairs[size - 1].pointer[0] = static_cast<std::uint32_t>(size - 2);  // two parents' child
    tree.pairs[size - 1].leaf[0] = false;
    const auto twice = compress<6>(tree, Code::modulo, disturbance, 9, 5);
    ASSERT_TRUE(twice.finished);
    EXPECT_EQ(twice.report.status.value(), static_cast<std::uint64_t>(Status::underflow));
    EXPECT_EQ(twice.report, compress<6>(tree, Code::modulo).report);
    tree = valid;
    tree.pairs[100].pointer[0] = 100;
    tree.pairs[100].leaf[0] = false;
    EXPECT_EQ(compress<6>(tree, Code::modulo, disturbance, 9, 5).report.status.value(),
              static_cast<std::uint64_t>(Status::underflow));
  }
}

}  // namespace
}  // namespace cbvh::rtl
