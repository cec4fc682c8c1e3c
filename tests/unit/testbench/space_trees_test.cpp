// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/eval/space/trees.h"

#include <gtest/gtest.h>

#include "golden/build/builder.h"

namespace cbvh::testbench {
namespace {

std::size_t with_figures(const std::string& scene) {
  std::size_t count = 0;
  for (const SpaceTree& tree : paper_space_trees()) count += paper_space_ratios(scene, tree.name).expected ? 1 : 0;
  return count;
}

TEST(SpaceTrees, stand_beside_the_papers_figures_for_its_scenes_alone) {
  EXPECT_EQ(paper_space_ratios("sponza", "G-BVH").expected, 121.2 / 142.6);
  EXPECT_EQ(paper_space_ratios("sponza", "GP-BVH, recursive").through, 177.5 / 195.3);
  EXPECT_EQ(paper_space_ratios("rotated:Sponza", "SS-BVH").terminating, 100.0 / 396);
  EXPECT_EQ(paper_space_ratios("folder/bunny", "KD-BVH").size, 6.6);
  EXPECT_FALSE(paper_space_ratios("bunny", "GP-BVH").size);
  EXPECT_EQ(with_figures("sponza"), 11U);
  EXPECT_EQ(with_figures("rotated:sponza"), 10U);
  EXPECT_EQ(with_figures("bunny"), 6U);
  EXPECT_EQ(with_figures("rotated:bunny"), 0U);
  EXPECT_EQ(with_figures("proc:city"), 0U);
}

TEST(SpaceTrees, have_builders_that_exist_and_budgets_that_follow_the_scene) {
  for (const SpaceTree& tree : paper_space_trees()) EXPECT_NO_THROW(golden::Builder("test", builder_text(tree, 1001)));
  EXPECT_NO_THROW(golden::Builder("test", builder_text(overlap_tree(1e16), 1001)));
  EXPECT_EQ(builder_text({"name", "spatial", 1.5}, 1001), "spatial,references=1502");
  EXPECT_EQ(builder_text({"name", "spatial"}, 1001), "spatial");
}

}  // namespace
}  // namespace cbvh::testbench
