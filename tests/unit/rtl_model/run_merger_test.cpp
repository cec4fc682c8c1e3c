// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "rtl_model/lbvh/run_merger.h"

#include <gtest/gtest.h>

#include "tests/support/merge_run.h"

namespace cbvh::rtl {
namespace {

using testing::random_runs;
using testing::run_merge;
using testing::SortedRun;
using testing::stable_sort_of;

/// A scratchpad for four runs of four records.
constexpr MergeConfig kFourRuns{512, 4, 16, 8, 256};

std::vector<SortRecord> records_of(const std::vector<SortItem>& items) {
  std::vector<SortRecord> records;
  for (const SortItem& item : items) records.push_back(item.record);
  return records;
}
std::vector<std::size_t> random_sizes(std::size_t count, std::uint64_t most, std::uint64_t seed) {
  SplitMix64 random(seed);
  std::vector<std::size_t> sizes(count);
  for (auto& size : sizes) size = 1 + random.below(most);
  return sizes;
}
std::size_t marks(const std::vector<SortItem>& items, UInt<1> SortItem::*mark) {
  return static_cast<std::size_t>(
      std::count_if(items.begin(), items.end(), [mark](const SortItem& item) { return bool(item.*mark); }));
}

TEST(RunMerger, merged_runs_are_the_stable_sort_of_all_records_under_every_stall) {
  std::size_t ties = 0;
  for (const std::size_t count : {1U, 2U, 3U, 4U, 5U, 9U, 16U, 17U, 37U}) {
    for (const std::uint64_t codes : {1ULL, 20ULL, 1ULL << kMortonBits}) {
      const auto runs = random_runs(random_sizes(count, 40, count), codes, count + codes);
      const auto want = stable_sort_of(runs);
      for (const auto& disturbance : testing::stall_matrix(count)) {
        for (const unsigned jitter : {0U, 30U}) {
          const auto run = run_merge(runs, kFourRuns, disturbance, 4 + jitter, jitter);
          ASSERT_TRUE(run.finished) << count << " runs";
          ASSERT_EQ(records_of(run.sorted), want) << count << " runs";
          EXPECT_EQ(marks(run.sorted, &SortItem::last), 1U);
          EXPECT_EQ(marks(run.sorted, &SortItem::last_of_run), 1U);
          ties += want.size();
        }
      }
    }
  }
  EXPECT_GT(ties, 50000U);
}

TEST(RunMerger, a_run_of_every_length_around_lines_batches_and_buffers_is_merged) {
  for (std::size_t size = 1; size <= 40; ++size) {
    for (const std::size_t count : {1U, 2U, 4U}) {
      const auto runs = random_runs(std::vector<std::size_t>(count, size), 50, size);
      const auto run = run_merge(runs, kFourRuns);
      ASSERT_TRUE(run.finished);
      EXPECT_EQ(records_of(run.sorted), stable_sort_of(runs)) << size;
    }
  }
}

TEST(RunMerger, runs_that_are_consumed_one_after_the_other_do_not_block_the_tournament) {
  constexpr MergeConfig kSmallestBuffers{64 * 64, 2, 1, 64, 64};  // 64 runs of one line
  for (const bool reverse : {false, true}) {
    for (const auto& [config, count] : {std::pair(kFourRuns, 4U), {kSmallestBuffers, 64U}, {MergeConfig(), 1024U}}) {
      std::vector<SortedRun> runs(count);
      for (std::size_t i = 0; i < 50 * count; ++i) {
        runs[reverse ? count - 1 - i / 50 : i / 50].push_back(testing::numbered_record(i, i));
      }
      const auto run = run_merge(runs, config, {}, 20);
      ASSERT_TRUE(run.finished) << count;
      EXPECT_EQ(records_of(run.sorted), stable_sort_of(runs));
    }
  }
}

TEST(RunMerger, as_few_records_as_must_be_are_rewritten) {
  const struct {
    std::size_t runs;
    std::size_t first_pass_runs;      ///< that are rewritten
    std::vector<std::size_t> groups;  ///< of each pass
  } rows[] = {{4, 0, {}},    {5, 2, {1}},      {6, 3, {1}},       {7, 4, {1}},         {8, 6, {2}},
              {16, 16, {4}}, {17, 17, {5, 1}}, {64, 64, {16, 4}}, {65, 65, {17, 5, 1}}};
  for (const auto& row : rows) {
    const auto runs = random_runs(std::vector<std::size_t>(row.runs, 6), 1000, row.runs);
    const auto run = run_merge(runs, kFourRuns);
    ASSERT_TRUE(run.finished);
    EXPECT_EQ(records_of(run.sorted), stable_sort_of(runs));
    ASSERT_EQ(run.rewritten.size(), row.groups.size()) << row.runs;
    for (std::size_t pass = 0; pass < row.groups.size(); ++pass) {
      EXPECT_EQ(marks(run.rewritten[pass], &SortItem::last_of_run), row.groups[pass]) << row.runs;
      EXPECT_EQ(marks(run.rewritten[pass], &SortItem::last), 1U);
      EXPECT_TRUE(run.rewritten[pass].back().last);
    }
    if (row.first_pass_runs == 0) continue;
    EXPECT_EQ(run.rewritten[0].size(), 6 * row.first_pass_runs) << row.runs;
  }
}

TEST(RunMerger, scenes_follow_each_other_whether_in_one_pass_or_in_several) {
  std::vector<std::vector<SortedRun>> scenes;
  for (const std::size_t count : {3U, 17U, 1U, 6U, 4U}) {
    scenes.push_back(random_runs(random_sizes(count, 20, count), 100, count));
  }
  std::vector<SortRecord> want;
  for (const auto& scene : scenes) {
    const auto sorted = stable_sort_of(scene);
    want.insert(want.end(), sorted.begin(), sorted.end());
  }
  for (const auto& disturbance : testing::stall_matrix()) {
    const auto run = testing::run_merges(scenes, kFourRuns, disturbance, 4, 9);
    ASSERT_TRUE(run.finished);
    EXPECT_EQ(records_of(run.sorted), want);
    EXPECT_EQ(marks(run.sorted, &SortItem::last), scenes.size());
  }
}

TEST(RunMerger, a_record_leaves_every_clock_while_no_buffer_is_dry) {
  for (const std::size_t count : {1U, 2U, 3U, 50U, 106U, 512U}) {
    const auto runs = random_runs(std::vector<std::size_t>(count, 60000 / count), 1 << 30, count);
    const auto run = run_merge(runs, {}, {}, 40);
    ASSERT_TRUE(run.finished);
    const std::uint64_t records = run.sorted.size();
    EXPECT_LE(run.given.back() - run.given.front(), records + records / 40 + 1) << count << " runs";
    // The first record leaves when every run has had its first batch.
    const std::uint64_t batch = BufferShape::of({}, count).batch_lines;
    EXPECT_LE(run.given.front(), 2 * count + 40 + count * batch + 16) << count << " runs";
  }
}

TEST(RunMerger, a_single_run_passes_at_a_record_a_clock_although_all_keys_take_one_path) {
  const auto runs = random_runs(std::vector<std::size_t>{5000, 1}, 1 << 30, 1);
  const auto run = run_merge(runs, {}, {}, 40);
  ASSERT_TRUE(run.finished);
  EXPECT_EQ(run.given.back() - run.given.front() + 1, 5001U);
}

TEST(RunMerger, every_line_is_read_once_and_in_batches_of_consecutive_lines) {
  MergeConfig config;
  config.refill_lines = 16;
  const std::size_t count = 100;  // 40 lines a run: two batches of 16
  const auto runs = random_runs(std::vector<std::size_t>(count, 320), 1 << 30, 7);
  const auto run = run_merge(runs, config, {}, 40);
  ASSERT_TRUE(run.finished);
  EXPECT_EQ(run.lines_read.size(), count * 160);
  std::size_t breaks = 0;
  for (std::size_t i = 1; i < run.lines_read.size(); ++i) breaks += run.lines_read[i] != run.lines_read[i - 1] + 1;
  EXPECT_LE(breaks + 1, count * 160 / 16);
  auto lines = run.lines_read;
  std::sort(lines.begin(), lines.end());
  EXPECT_TRUE(std::adjacent_find(lines.begin(), lines.end()) == lines.end());
}

TEST(RunMerger, as_many_lines_are_under_way_as_the_configuration_allows_and_no_more) {
  for (const std::uint64_t outstanding : {1U, 7U, 64U}) {
    MergeConfig config;
    config.outstanding = outstanding;
    const auto run = run_merge(random_runs(std::vector<std::size_t>(8, 500), 1 << 30, 7), config, {}, 100);
    ASSERT_TRUE(run.finished);
    EXPECT_EQ(run.most_under_way, outstanding);
  }
}

TEST(RunMerger, buffers_share_the_scratchpad_in_whole_batches) {
  const MergeConfig config;
  EXPECT_EQ(config.most_runs(), 1024U);
  const struct {
    std::uint64_t runs, batch, buffer;
  } rows[] = {{1024, 2, 4}, {512, 4, 8}, {128, 16, 32}, {106, 16, 32}, {50, 16, 80}, {1, 16, 4096}, {700, 2, 4}};
  for (const auto& row : rows) {
    const BufferShape shape = BufferShape::of(config, row.runs);
    EXPECT_EQ(shape.batch_lines, row.batch) << row.runs;
    EXPECT_EQ(shape.buffer_lines, row.buffer) << row.runs;
    EXPECT_LE(row.runs * shape.buffer_lines, config.scratchpad_lines());
  }
}

TEST(RunMerger, a_configuration_that_does_not_fit_is_named_by_its_field) {
  const auto broken = [](std::uint64_t MergeConfig::*field, std::uint64_t value) {
    MergeConfig config;
    config.*field = value;
    return config.inconsistent_field();
  };
  EXPECT_EQ(MergeConfig{}.inconsistent_field(), "");
  EXPECT_EQ(kFourRuns.inconsistent_field(), "");
  EXPECT_EQ(broken(&MergeConfig::scratchpad_bytes, 1000), "scratchpad_bytes");
  EXPECT_EQ(broken(&MergeConfig::scratchpad_bytes, 256), "minimum_buffer_records");
  EXPECT_EQ(broken(&MergeConfig::minimum_buffer_records, 0), "minimum_buffer_records");
  EXPECT_EQ(broken(&MergeConfig::minimum_buffer_records, 7), "minimum_buffer_records");
  EXPECT_EQ(broken(&MergeConfig::minimum_buffer_records, 8192), "minimum_buffer_records");
  EXPECT_EQ(broken(&MergeConfig::refill_lines, 0), "refill_lines");
  EXPECT_EQ(broken(&MergeConfig::outstanding, 0), "outstanding");
  EXPECT_EQ(broken(&MergeConfig::table_runs, 0), "table_runs");
}

}  // namespace
}  // namespace cbvh::rtl
