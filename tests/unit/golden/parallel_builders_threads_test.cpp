// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <atomic>

#include "golden/scene/load.h"
#include "golden/threads/team.h"
#include "tests/unit/golden/built_tree_checks.h"

namespace cbvh::golden {
namespace {

/// Large enough for several meetings of all threads at the top.
std::vector<Mesh> scenes() {
  std::vector<Mesh> all;
  for (const char* name : {"proc:soup,triangles=9000"}) all.push_back(load_scene(name));
  // All alike, which bins cannot split; and one far away, which they cut off at once.
  Mesh stack{"stack", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {9, 9, 9}}, std::vector<glm::uvec3>(4500, {0, 1, 2})};
  all.push_back(stack);
  stack.name = "stack and one";
  stack.triangles[777] = {3, 3, 3};
  all.push_back(stack);
  return all;
}

class ParallelBuilders : public ::testing::TestWithParam<const char*> {};

TEST_P(ParallelBuilders, ten_runs_with_1_2_and_4_threads_give_the_same_tree) {
  for (const Mesh& mesh : scenes()) {
    const FloatTree alone = build(GetParam(), mesh);
    expect_tree_of_all_triangles(alone, mesh, 4, 32);
    for (int run = 0; run < 10; ++run) {
      for (const int threads : {1, 2, 4}) {
        const FloatTree together = build(fmt::format("{},threads={}", GetParam(), threads), mesh);
        expect_same_tree(together, alone, mesh.name);
        if (HasFatalFailure()) return;
        EXPECT_EQ(together.scene.lower, alone.scene.lower);
        EXPECT_EQ(together.scene.upper, alone.scene.upper);
        EXPECT_EQ(together.largest_magnitude, alone.largest_magnitude);
        EXPECT_EQ(together.primitives, alone.primitives);
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, ParallelBuilders,
                         ::testing::Values("binned", "binned,bins=5,depth=15", "binned,top=grid", "median",
                                           "median,depth=13"),
                         [](const auto& place) { return fmt::format("{}", place.index); });

TEST(Team, shares_are_all_there_is_in_order_and_nobody_passes_a_meeting_before_all_are_there) {
  constexpr std::uint32_t kCount = 1001;
  for (const unsigned threads : {1U, 2U, 5U}) {
    std::vector<int> taken(kCount);
    std::vector<TeamMember::Share> shares(threads);
    std::atomic<unsigned> arrived = 0;
    std::atomic<int> early = 0;
    run_team(threads, [&](const TeamMember& member) {
      shares[member.index()] = member.share(kCount);
      for (std::uint32_t i = member.share(kCount).first; i < member.share(kCount).last; ++i) ++taken[i];
      for (unsigned meeting = 1; meeting <= 20; ++meeting) {
        ++arrived;
        member.wait();
        if (arrived < meeting * threads) ++early;
        member.wait();
      }
    });
    EXPECT_EQ(taken, std::vector<int>(kCount, 1));
    for (unsigned i = 1; i < threads; ++i) EXPECT_EQ(shares[i].first, shares[i - 1].last);
    EXPECT_EQ(arrived, 20 * threads);
    EXPECT_EQ(early, 0);
  }
}

}  // namespace
}  // namespace cbvh::golden
