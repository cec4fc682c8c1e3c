// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// Figure 10's reference results of DESIGN 3.2, measured by two threads.
#include <gtest/gtest.h>

#include "testbench/eval/sections.h"

namespace cbvh::testbench {
namespace {

TEST(Eval, cloth_gives_the_tabulated_minimum_scale_sweep) {
  EvalJob job;
  job.scenes = {"proc:cloth"};
  job.sweep = {-126, -60, -30, -20, -15, -10, -5, std::nullopt};
  job.threads = 2;
  const SceneMeasure scene = measure_scenes(job).at(0);
  EXPECT_TRUE(scene.failures.empty());
  EXPECT_EQ(scene.checks, 16U);
  const std::uint64_t one_level[] = {22712, 1236, 244, 228, 212, 48, 0, 228};
  const std::uint64_t four_levels[] = {22468, 992, 0, 0, 0, 0, 0, 0};
  const double sah[] = {1, 1, 1, 1, 1.0005, 1.033, 4.67, 1};
  const double half_digit[] = {5e-5, 5e-5, 5e-5, 5e-5, 5e-5, 5e-4, 5e-3, 5e-5};
  ASSERT_EQ(scene.sweep.size(), 8U);
  const Table table = figure10_tables({scene}).at(1);
  for (std::size_t i = 0; i < scene.sweep.size(); ++i) {
    EXPECT_EQ(scene.sweep[i].one_level, one_level[i]) << i;
    EXPECT_EQ(scene.sweep[i].four_levels, four_levels[i]) << i;
    EXPECT_NEAR(table.rows[i].back().get<double>(), sah[i], half_digit[i]) << i;
  }
}

}  // namespace
}  // namespace cbvh::testbench
