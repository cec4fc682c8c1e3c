// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "tests/support/ray_walk.h"

namespace cbvh::testing {
namespace {

TEST(PairIntersectorNightly, no_interval_of_a_hundred_million_box_tests_fails_to_enclose_the_exact_one) {
  constexpr std::uint64_t kTests = 100'000'000;
  const WalkedBoxes walked = walk_rays<6>(kTests, 7);
  EXPECT_GE(walked.tests, kTests);
  EXPECT_EQ(walked.violations, 0U);
  EXPECT_EQ(walked.refused, 0U);
  EXPECT_GT(walked.hits, kTests / 20);
}

}  // namespace
}  // namespace cbvh::testing
