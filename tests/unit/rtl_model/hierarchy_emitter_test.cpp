// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "rtl_model/lbvh/hierarchy_emitter.h"

#include <gtest/gtest.h>

#include "rtl_model/datapath/record_words.h"
#include "tests/support/emit_run.h"

namespace cbvh::rtl {
namespace {

using golden::CodedBox;
using testing::run_emitter;
using testing::sort_items;
using testing::sorted_boxes;

const SceneRegisters kRegisters{Scale(-20), UInt<1>(1), UInt<1>(0)};

/// Pairs and IDs are those of the tree; the report tells its sizes.
std::size_t expect_tree(const testing::EmitRun& run, const golden::FloatTree& tree, const std::string& name) {
  EXPECT_TRUE(run.finished) << name;
  EXPECT_EQ(run.jobs.size(), tree.pairs.size()) << name;
  EXPECT_EQ(run.ids.size(), tree.primitive_ids.size()) << name;
  if (::testing::Test::HasFailure()) return 0;
  for (std::size_t i = 0; i < run.jobs.size(); ++i) {
    EXPECT_EQ(run.jobs[i], vectors::stream_job(tree, i, kRegisters)) << name << " pair " << i;
    if (::testing::Test::HasFailure()) return 0;
  }
  for (std::size_t i = 0; i < run.ids.size(); ++i) {
    EXPECT_EQ(id_word(run.ids[i]).value(), tree.primitive_ids[i]) << name << " entry " << i;
    EXPECT_EQ(bool(run.ids[i].last), i + 1 == run.ids.size());
  }
  const EmitReport& report = run.reports[0];
  EXPECT_EQ(report.pairs.value(), tree.pairs.size());
  EXPECT_EQ(report.leaves.value(), tree.leaves);
  EXPECT_EQ(report.primitives.value(), tree.primitives);
  EXPECT_EQ(report.root, vectors::float_box(tree.scene));
  return run.jobs.size() + run.ids.size();
}

std::vector<CodedBox> with_codes(const std::vector<std::uint32_t>& codes) {
  std::vector<CodedBox> sorted;
  for (const std::uint32_t code : codes) {
    const auto id = static_cast<std::uint32_t>(sorted.size());
    const float x = static_cast<float>((id * 37) % 101) - 50;
    sorted.push_back({{{x, -x, -3}, {x + 1, 60, x * x}}, code, 5000 - id});
  }
  return sorted;
}
std::vector<std::uint32_t> right_spine() {  // every code shares one bit more with those behind it
  std::vector<std::uint32_t> codes{0};
  for (int bit = 0; bit < kMortonBits; ++bit) codes.push_back(codes.back() | 1U << (kMortonBits - 1 - bit));
  return codes;
}
std::vector<std::uint32_t> left_spine() {
  std::vector<std::uint32_t> codes{0};
  for (int bit = 0; bit < kMortonBits; ++bit) codes.push_back(1U << bit);
  return codes;
}
constexpr std::uint32_t kHighest = (1U << kMortonBits) - 1;

TEST(HierarchyEmitter, pairs_and_ids_of_scenes_are_those_of_the_golden_builder) {
  std::size_t checks = 0;
  for (const std::string scene : {"proc:cloth", "proc:soup", "proc:spheres", "proc:city", "proc:terrain"}) {
    const auto run = run_emitter(sort_items(sorted_boxes(scene)), kRegisters);
    checks += expect_tree(run, golden::build_lbvh(golden::load_scene(scene)), scene);
  }
  EXPECT_GT(checks, 100000U);
}

TEST(HierarchyEmitter, tree_is_unchanged_by_stalls_and_order_of_evaluation) {
  const std::string scene = "proc:cloth,sheet=24,height=20";
  const auto items = sort_items(sorted_boxes(scene));
  const auto tree = golden::build_lbvh(golden::load_scene(scene));
  for (const auto& disturbance : testing::stall_matrix()) {
    expect_tree(run_emitter(items, kRegisters, disturbance), tree, scene);
  }
}

TEST(HierarchyEmitter, spines_ends_of_the_curve_and_leaves_of_many_are_those_of_the_golden_hierarchy) {
  const std::vector<std::vector<std::uint32_t>> lists = {
      {0}, {kHighest}, {0, kHighest}, {7, 7, 7, 7, 7}, {0, 0, 1, kHighest, kHighest}, left_spine(), right_spine()};
  std::size_t deepest = 0;
  for (const auto& codes : lists) {
    const auto sorted = with_codes(codes);
    const auto run = run_emitter(sort_items(sorted), kRegisters);
    expect_tree(run, golden::build_hierarchy(sorted), std::to_string(codes.size()) + " codes");
    deepest = std::max<std::size_t>(deepest, run.reports[0].depth.value());
  }
  EXPECT_EQ(deepest, 30U);
}

TEST(HierarchyEmitter, equal_codes_are_one_leaf_without_pairs) {
  const auto run = run_emitter(sort_items(with_codes(std::vector<std::uint32_t>(9, 5))), kRegisters);
  EXPECT_TRUE(run.finished);
  EXPECT_TRUE(run.jobs.empty());
  EXPECT_EQ(run.reports[0].leaves.value(), 1U);
  for (std::size_t i = 0; i < 9; ++i) EXPECT_EQ(bool(run.ids[i].last_of_leaf), i == 8);
}

TEST(HierarchyEmitter, scenes_follow_each_other) {
  std::vector<SortItem> items;
  std::vector<golden::FloatTree> trees;
  for (const auto& codes : {left_spine(), std::vector<std::uint32_t>{3}, right_spine()}) {
    const auto sorted = with_codes(codes);
    for (const auto& item : sort_items(sorted)) items.push_back(item);
    trees.push_back(golden::build_hierarchy(sorted));
  }
  for (const auto& disturbance : testing::stall_matrix()) {
    auto run = run_emitter(items, kRegisters, disturbance);
    ASSERT_TRUE(run.finished);
    for (const auto& tree : trees) {
      testing::EmitRun one;
      one.finished = true;
      const auto pairs = static_cast<std::ptrdiff_t>(tree.pairs.size());
      one.jobs.assign(run.jobs.begin(), run.jobs.begin() + pairs);
      run.jobs.erase(run.jobs.begin(), run.jobs.begin() + pairs);
      one.ids.assign(run.ids.begin(), run.ids.begin() + tree.primitives);
      run.ids.erase(run.ids.begin(), run.ids.begin() + tree.primitives);
      one.reports.assign(run.reports.begin(), run.reports.begin() + 1);
      run.reports.erase(run.reports.begin());
      expect_tree(one, tree, "scene");
    }
  }
}

TEST(HierarchyEmitter, a_record_a_clock_is_taken_while_nothing_or_one_pair_closes_and_a_pair_a_clock_leaves) {
  // Of the right spine everything closes at the end, of the left spine one pair with each record.
  constexpr std::uint64_t kOverhead = 4;  // into the unit, the last ID, the report, out of it
  const auto cycles = [](const std::vector<std::uint32_t>& codes) {
    return run_emitter(sort_items(with_codes(codes)), kRegisters).cycles;
  };
  EXPECT_LE(cycles(right_spine()), 31 + 30 + kOverhead);
  EXPECT_LE(cycles(left_spine()), 31 + 1 + kOverhead);
  EXPECT_LE(cycles(std::vector<std::uint32_t>(500, 1)), 500 + kOverhead);
  std::vector<std::uint32_t> full(4096);  // a full binary tree: half of the records close nothing
  for (std::uint32_t i = 0; i < full.size(); ++i) full[i] = i;
  EXPECT_LE(cycles(full), 4096 + 2048 + kOverhead);
}

}  // namespace
}  // namespace cbvh::rtl
