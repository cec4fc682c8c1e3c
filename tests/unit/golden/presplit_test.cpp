// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// Triangles split before the sweep: early split clipping and the edge volume heuristic.
#include <gtest/gtest.h>

#include "built_tree_checks.h"
#include "golden/input_error.h"
#include "golden/scene/load.h"
#include "golden/scene/trouble_scenes.h"
#include "golden/tree/coverage.h"
#include "golden/tree/sah.h"

namespace cbvh::golden {
namespace {

const char* const kBuilders[] = {"early-split,area=0.01", "early-split,area=0.0001,leaf=1,references=40",
                                 "edge-volume,t=8,leaf=1", "edge-volume,t=40,references=40"};

TEST(Presplit, trees_of_trouble_cover_every_triangle_exactly_and_stream_as_top_down) {
  std::size_t shared = 0;
  for (std::uint64_t id = 0; id < 48; ++id) {
    const Mesh mesh = trouble_scene(kTroubles[id % kTroubles.size()], id, 14);
    for (const char* const builder : kBuilders) {
      const FloatTree tree = build(builder, mesh);
      const std::string name = fmt::format("{} {}", builder, mesh.name);
      for (const std::string& finding : check_tree(tree, mesh)) ADD_FAILURE() << name << ": " << finding;
      for (const CoverageGap& gap : coverage_gaps(tree, mesh))
        ADD_FAILURE() << name << ": triangle " << gap.triangle << " at " << gap.witness[0];
      expect_streams_as_top_down(tree, name);
      shared += tree.primitive_ids.size() > tree.primitives ? 1 : 0;
    }
  }
  EXPECT_GT(shared, 60U);
}

TEST(Presplit, an_edge_whose_middle_is_not_in_binary64_leaves_no_gap) {
  // The middle is (1/2 + 2^-61, 1/2, 1/2). Rounded, the first half would end at x = 1/2, and the second one begin at
  // y = 1/2: what the edge has between them would be in neither box.
  Mesh mesh;
  mesh.name = "edge";
  mesh.positions = {{0x1p-60F, 0, 0}, {1, 1, 1}, {0, 1, 0.5F}};
  mesh.triangles = {{0, 1, 2}};
  const FloatTree tree = build("edge-volume,t=1,leaf=1", mesh);
  EXPECT_EQ(tree.leaves, 2U);
  EXPECT_TRUE(check_tree(tree, mesh).empty());
  EXPECT_TRUE(coverage_gaps(tree, mesh).empty());
}

TEST(Presplit, trees_of_larger_scenes_cover_and_are_the_same_every_time) {
  const Mesh mesh = load_scene("rotated:proc:city,triangles=300");
  for (const char* const builder : {"early-split,area=0.001", "edge-volume,t=12"}) {
    const FloatTree tree = build(builder, mesh);
    EXPECT_GT(tree.primitive_ids.size(), 11 * mesh.triangles.size() / 10) << builder;
    EXPECT_TRUE(check_tree(tree, mesh).empty()) << builder;
    EXPECT_TRUE(coverage_gaps(tree, mesh, 7).empty()) << builder;
    EXPECT_LT(sah(tree), sah(build("sweep", mesh))) << builder;
    expect_same_tree(build(builder, mesh), tree, builder);
  }
}

TEST(Presplit, where_nothing_is_too_large_the_tree_is_the_sweeps) {
  const Mesh across = load_scene("rotated:proc:city,triangles=300");
  const FloatTree sweep = build("sweep", across);
  expect_same_tree(build("early-split,area=1", across), sweep, "early-split");
  expect_same_tree(build("edge-volume,t=0", across), sweep, "edge-volume");
  // Along the axes no box around an edge has volume (paper 001, table 2: the original scene does not change).
  const Mesh along = load_scene("proc:city,triangles=300");
  expect_same_tree(build("edge-volume,t=64", along), build("sweep", along), "edge-volume along the axes");
  EXPECT_GT(build("early-split,area=0.0001", along).primitive_ids.size(), along.triangles.size());
}

TEST(Presplit, smaller_thresholds_split_more_within_the_budget) {
  const Mesh mesh = load_scene("rotated:proc:city,triangles=300");
  const std::size_t triangles = mesh.triangles.size();
  const auto references = [&](const std::string& builder) { return build(builder, mesh).primitive_ids.size(); };
  EXPECT_LT(references("edge-volume,t=10"), references("edge-volume,t=14"));
  EXPECT_LT(references("early-split,area=0.01"), references("early-split,area=0.001"));
  for (const char* const builder : {"early-split,area=0.00001", "edge-volume,t=20"}) {
    const std::size_t budget = triangles + triangles / 4;
    const FloatTree tree = build(fmt::format("{},references={}", builder, budget), mesh);
    EXPECT_LE(tree.primitive_ids.size(), budget);
    EXPECT_GT(tree.primitive_ids.size(), triangles);
    EXPECT_TRUE(coverage_gaps(tree, mesh, 7).empty());
    try {
      build(fmt::format("{},references={}", builder, triangles - 1), mesh);
      FAIL();
    } catch (const InputError& error) {
      EXPECT_EQ(std::string(error.what()), fmt::format("{}: {} triangles, but at most {} references are allowed",
                                                       mesh.name, triangles, triangles - 1));
    }
  }
}

}  // namespace
}  // namespace cbvh::golden
