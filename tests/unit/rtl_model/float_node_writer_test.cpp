// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "rtl_model/lbvh/float_node_writer.h"

#include <gtest/gtest.h>

#include "golden/build/lbvh.h"
#include "golden/scene/load.h"
#include "golden/tree/float_pair_format.h"
#include "tests/support/write_run.h"
#include "vectors/convert.h"

namespace cbvh::rtl {
namespace {

constexpr std::uint64_t kBase = 77;

const golden::FloatTree& cloth() {
  static const auto tree = golden::build_lbvh(golden::load_scene("proc:cloth,sheet=12,height=10"));
  return tree;
}
std::vector<StreamJob> jobs_of(const golden::FloatTree& tree) {
  std::vector<StreamJob> jobs;
  for (std::size_t i = 0; i < tree.pairs.size(); ++i) jobs.push_back(vectors::stream_job(tree, i, {}));
  return jobs;
}

TEST(FloatNodeWriter, memory_is_the_golden_layout_of_every_pair_at_the_report_under_every_stall) {
  const auto jobs = jobs_of(cloth());
  for (const auto& disturbance : testing::stall_matrix()) {
    const auto run =
        testing::run_writer<FloatNodeWriter, StreamJob>(jobs, 1, kBase, jobs.size() * kWordsPerLine, disturbance);
    ASSERT_TRUE(run.finished);
    for (std::size_t i = 0; i < jobs.size(); ++i) {
      const auto want = golden::pack_float_pair(cloth().pairs[i]);
      EXPECT_TRUE(std::equal(want.begin(), want.end(), &run.words[i * kWordsPerLine])) << "pair " << i;
    }
    EXPECT_EQ(run.reports[0].items.value(), jobs.size());
    EXPECT_EQ(run.reports[0].lines.value(), jobs.size());
    EXPECT_EQ(run.writes, jobs.size());
  }
}

TEST(FloatNodeWriter, takes_a_pair_a_clock_and_begins_again_with_the_next_tree) {
  auto jobs = jobs_of(cloth());
  constexpr std::uint64_t kOverhead = 13;  // through the port, the acknowledgement and back
  const auto one = testing::run_writer<FloatNodeWriter, StreamJob>(jobs, 1, kBase, 0);
  EXPECT_LE(one.cycles, jobs.size() + kOverhead);
  jobs.push_back(jobs.back());
  const auto two = testing::run_writer<FloatNodeWriter, StreamJob>(jobs, 2, kBase, kWordsPerLine);
  ASSERT_TRUE(two.finished);
  EXPECT_EQ(two.reports[1].items.value(), 1U);
  const auto want = golden::pack_float_pair(cloth().pairs.back());
  EXPECT_TRUE(std::equal(want.begin(), want.end(), two.words.data()));
}

TEST(FloatNodeWriter, pointers_and_leaf_marks_fill_their_bits) {
  StreamJob job;
  job.pair.pointer = {Pointer((1U << 27) - 1), Pointer(1)};
  job.pair.leaf = {UInt<1>(0), UInt<1>(1)};
  job.pair.box[1].upper[2] = Float32::of(-1.5F);
  job.root = UInt<1>(1);
  const auto run = testing::run_writer<FloatNodeWriter, StreamJob>(std::vector{job}, 1, kBase, kWordsPerLine);
  ASSERT_TRUE(run.finished);
  EXPECT_EQ(run.words[6], 0x07FFFFFFU);
  EXPECT_EQ(run.words[7], 0U);
  EXPECT_EQ(run.words[13], 0xBFC00000U);
  EXPECT_EQ(run.words[14], 0x80000001U);
}

}  // namespace
}  // namespace cbvh::rtl
