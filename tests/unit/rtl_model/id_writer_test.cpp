// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "rtl_model/lbvh/id_writer.h"

#include <gtest/gtest.h>

#include "tests/support/write_run.h"

namespace cbvh::rtl {
namespace {

constexpr std::uint64_t kBase = 77;

std::vector<IdEntry> entries_of(std::size_t count) {
  std::vector<IdEntry> entries;
  for (std::size_t i = 0; i < count; ++i) {
    entries.push_back({Pointer((1U << 27) - 1 - i * 5), UInt<1>(i % 3 == 0), UInt<1>(i + 1 == count)});
  }
  return entries;
}

TEST(IdWriter, every_entry_is_in_memory_at_the_report_and_nothing_else_has_changed) {
  for (const std::size_t count : {1U, 2U, 15U, 16U, 17U, 31U, 32U, 33U, 1600U, 1601U}) {
    for (const auto& disturbance : testing::stall_matrix(count)) {
      const auto run = testing::run_writer<IdWriter, IdEntry>(entries_of(count), 1, kBase, count + 16, disturbance);
      ASSERT_TRUE(run.finished) << count;
      for (std::size_t i = 0; i < count; ++i) {
        const std::uint32_t id = (1U << 27) - 1 - static_cast<std::uint32_t>(i) * 5;
        EXPECT_EQ(run.words[i], id + (i % 3 == 0 ? 0x80000000U : 0U)) << count << " entries, entry " << i;
      }
      for (std::size_t i = count; i < count + 16; ++i) EXPECT_EQ(run.words[i], testing::kUntouched) << count;
      EXPECT_EQ(run.reports[0].items.value(), count);
      EXPECT_EQ(run.reports[0].lines.value(), (count + 15) / 16);
      EXPECT_EQ(run.writes, (count + 15) / 16);
    }
  }
}

TEST(IdWriter, takes_an_entry_a_clock) {
  constexpr std::size_t kCount = 1600;
  constexpr std::uint64_t kOverhead = 13;  // through the port, the acknowledgement and back
  const auto run = testing::run_writer<IdWriter, IdEntry>(entries_of(kCount), 1, kBase, 0);
  EXPECT_LE(run.cycles, kCount + kOverhead);
}

TEST(IdWriter, begins_again_at_its_base_with_the_next_scene) {
  auto entries = entries_of(40);
  const auto next = entries_of(3);
  entries.insert(entries.end(), next.begin(), next.end());
  const auto run = testing::run_writer<IdWriter, IdEntry>(entries, 2, kBase, 40);
  ASSERT_TRUE(run.finished);
  EXPECT_EQ(run.reports[1].items.value(), 3U);
  EXPECT_EQ(run.reports[1].lines.value(), 1U);
  EXPECT_EQ(run.words[2], (1U << 27) - 1 - 10);
}

}  // namespace
}  // namespace cbvh::rtl
