// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "rtl_model/compress/stream_compressor.h"

#include <gtest/gtest.h>

#include "golden/build/lbvh.h"
#include "golden/quantize/quantize.h"
#include "golden/scene/load.h"
#include "golden/tree/digest.h"
#include "golden/update/streaming.h"
#include "golden/update/top_down.h"
#include "rtl_model/compress/lazy_treelet_collector.h"
#include "tests/support/stream_run.h"

namespace cbvh::rtl {
namespace {

using golden::Code;
using golden::ScaleRule;
using testing::Disturbance;
using testing::run_stream;

const golden::FloatTree& cloth() {
  static const auto tree = golden::build_lbvh(golden::load_scene("proc:cloth"));
  return tree;
}
/// A smaller one, for many runs.
const golden::FloatTree& small_cloth() {
  static const auto tree = golden::build_lbvh(golden::load_scene("proc:cloth,sheet=24,height=20"));
  return tree;
}
golden::GridRules rules_of(const golden::FloatTree& tree, ScaleRule rule = ScaleRule::equation2) {
  return {6, golden::exactness_limit(tree.largest_magnitude), rule};
}

struct Row {
  ScaleRule rule;
  Code code;
  std::uint64_t digest;
  std::uint64_t repairs[4];  ///< D = 1..4
};

/// DESIGN 3.2, both tables, proc:cloth.
const Row kCloth[] = {
    {ScaleRule::equation2, Code::relative, 0x8bd6f10416322ba7, {19275, 156, 38, 0}},
    {ScaleRule::equation2, Code::modulo, 0x8bd6f10416322ba7, {228, 22, 0, 0}},
    {ScaleRule::figure5, Code::relative, 0xa5e5eebd9bf15fb1, {20814, 1493, 745, 114}},
    {ScaleRule::figure5, Code::modulo, 0xa5e5eebd9bf15fb1, {1262, 594, 80, 24}},
};

template <template <class, int> class Collector>
void expect_reference_rows() {
  for (const auto& row : kCloth) {
    const auto rules = rules_of(cloth(), row.rule);
    auto tree = golden::compress_top_down(cloth(), rules, row.code);
    const auto top_down = tree.pairs;
    for (int levels = 1; levels <= 4; ++levels) {
      const auto run = run_stream<6, Collector>(cloth(), vectors::scene_registers(rules, row.code), levels);
      ASSERT_TRUE(run.finished);
      EXPECT_EQ(run.report.repairs.value(), row.repairs[levels - 1]);
      EXPECT_EQ(run.report.last_index.value() + 1, cloth().pairs.size());
      EXPECT_TRUE(run.pairs == top_down);
      tree.pairs = run.pairs;
      EXPECT_EQ(golden::digest(tree), row.digest);
    }
  }
}

TEST(StreamCompressor, streamed_cloth_has_the_reference_digest_and_backtracks_for_every_treelet_depth) {
  expect_reference_rows<TreeletCollector>();
}
TEST(StreamCompressor, lazy_collector_writes_the_same_bits_with_the_same_backtracks) {
  expect_reference_rows<LazyTreeletCollector>();
}

template <template <class, int> class Collector>
void expect_undisturbed() {
  const auto rules = rules_of(small_cloth());
  for (const auto code : {Code::modulo, Code::relative}) {
    const auto top_down = golden::compress_top_down(small_cloth(), rules, code).pairs;
    for (const int levels : {1, 2, 3, 5, 8}) {
      const auto quiet = run_stream<6, Collector>(small_cloth(), vectors::scene_registers(rules, code), levels);
      for (const auto& disturbance : testing::stall_matrix()) {
        const auto run =
            run_stream<6, Collector>(small_cloth(), vectors::scene_registers(rules, code), levels, disturbance, 9);
        ASSERT_TRUE(run.finished);
        EXPECT_TRUE(run.pairs == top_down);
        EXPECT_EQ(run.report, quiet.report);
      }
    }
  }
}

TEST(StreamCompressor, tree_is_unchanged_by_stalls_memory_jitter_and_order_of_evaluation) {
  expect_undisturbed<TreeletCollector>();
}
TEST(StreamCompressor, lazy_tree_is_unchanged_by_stalls_memory_jitter_and_order_of_evaluation) {
  expect_undisturbed<LazyTreeletCollector>();
}

TEST(StreamCompressor, sustains_a_pair_a_cycle_when_nothing_backtracks) {
  const auto rules = rules_of(cloth());
  const auto registers = vectors::scene_registers(rules, Code::modulo);
  for (const int levels : {3, 4}) {
    const auto run = run_stream<6>(cloth(), registers, levels);
    ASSERT_EQ(run.report.repairs.value(), 0u);
    EXPECT_LE(static_cast<double>(run.cycles), 1.005 * static_cast<double>(cloth().pairs.size()) + 100);
  }
}

TEST(StreamCompressor, repair_of_a_pair_in_the_line_being_combined_sees_it) {
  // Relative codes without treelets repair most children right after they were written: many are still in the combining
  // line.
  const auto rules = rules_of(small_cloth());
  const auto top_down = golden::compress_top_down(small_cloth(), rules, Code::relative).pairs;
  const auto run = run_stream<6>(small_cloth(), vectors::scene_registers(rules, Code::relative), 1);
  EXPECT_GT(run.report.repairs.value(), 100u);
  EXPECT_EQ(run.reads, run.report.repairs.value());
  EXPECT_TRUE(run.pairs == top_down);
}

TEST(StreamCompressor, refused_pair_ends_the_tree_with_its_index_and_reason) {
  auto broken = small_cloth();
  broken.pairs[5].child[0].lower.y = std::numeric_limits<float>::infinity();
  const auto rules = rules_of(small_cloth());
  const auto registers = vectors::scene_registers(rules, Code::modulo);
  for (const int levels : {1, 3}) {
    const auto run = run_stream<6>(broken, registers, levels);
    ASSERT_TRUE(run.finished);
    EXPECT_EQ(run.report.status.value(), static_cast<std::uint64_t>(Status::not_finite));
    EXPECT_EQ(run.report.last_index.value(), 5u);
  }
}

}  // namespace
}  // namespace cbvh::rtl
