// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// The geometric and the generic partitioner: their oracles, penalty and weighing of subtrees.
#include "golden/build/generic.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "built_tree_checks.h"
#include "golden/build/grid_oracle.h"
#include "golden/build/middle_split.h"
#include "golden/build/partition_search.h"
#include "golden/input_error.h"
#include "golden/scene/load.h"
#include "golden/scene/trouble_scenes.h"
#include "golden/tree/coverage.h"
#include "golden/tree/sah.h"

namespace cbvh::golden {
namespace {

const char* const kBuilders[] = {"geometric,resolution=8",
                                 "geometric,centroids=0,leaf=1",
                                 "generic,resolution=8",
                                 "generic,overlap=1e16,leaf=2",
                                 "generic,oracle=grid,resolution=16",
                                 "generic,oracle=grid,split=0,recursion=3,resolution=8",
                                 "generic,oracle=kd+grid,recursion=5,overlap=2",
                                 "generic,oracle=centroid,overlap=10"};

TEST(Generic, trees_of_trouble_cover_every_triangle_exactly_and_stream_as_top_down) {
  std::size_t shared = 0;
  for (std::uint64_t id = 0; id < 36; ++id) {
    const Mesh mesh = trouble_scene(kTroubles[id % kTroubles.size()], id, 14);
    for (const char* const builder : kBuilders) {
      const FloatTree tree = build(builder, mesh);
      const std::string name = fmt::format("{} {}", builder, mesh.name);
      for (const std::string& finding : check_tree(tree, mesh)) ADD_FAILURE() << name << ": " << finding;
      for (const CoverageGap& gap : coverage_gaps(tree, mesh))
        ADD_FAILURE() << name << ": triangle " << gap.triangle << " at " << gap.witness[0];
      EXPECT_LE(depth(tree), 32);
      expect_streams_as_top_down(tree, name);
      shared += tree.primitive_ids.size() > tree.primitives ? 1 : 0;
    }
  }
  EXPECT_GT(shared, 30U);
}

TEST(Generic, trees_of_larger_scenes_cover_and_are_the_same_every_time) {
  for (const char* const scene : {"rotated:proc:city,triangles=134", "proc:hairball,triangles=100"}) {
    const Mesh mesh = load_scene(scene);
    for (const char* const builder : kBuilders) {
      const FloatTree tree = build(builder, mesh);
      EXPECT_TRUE(check_tree(tree, mesh).empty()) << builder;
      EXPECT_TRUE(coverage_gaps(tree, mesh, 7).empty()) << builder;
      expect_same_tree(build(builder, mesh), tree, scene);
    }
  }
}

TEST(Generic, with_centroids_alone_builds_the_sweeps_trees) {
  for (std::uint64_t id = 0; id < 120; ++id) {
    const Mesh mesh = trouble_scene(kTroubles[id % kTroubles.size()], id, 60);
    const std::string options = fmt::format(",leaf={},depth={},traversal={},intersection={}", 1 + id % 5, 6 + id % 3,
                                            static_cast<double>(id % 4) * 0.5, 1 + id % 3);
    expect_same_tree(build("generic,oracle=centroid" + options, mesh), build("sweep" + options, mesh), mesh.name);
    if (HasFatalFailure()) return;
  }
}

TEST(Generic, with_planes_alone_builds_the_spatial_splits_trees) {
  for (std::uint64_t id = 0; id < 60; ++id) {
    const Mesh mesh = trouble_scene(kTroubles[id % kTroubles.size()], id, 30);
    expect_same_tree(build("generic,oracle=kd,overlap=7", mesh), build("spatial", mesh), mesh.name);
    if (HasFatalFailure()) return;
  }
}

struct Small {
  Mesh mesh;
  std::vector<Piece> pieces;
  Box cell;
};

/// Triangles on whole coordinates in a cube whose sides are on 0 and 12, so that its grid is exact.
Small random_small(std::mt19937& random, std::uint32_t triangles) {
  Small small;
  const auto coordinate = [&] { return static_cast<float>(random() % 13); };
  for (std::uint32_t id = 0; id < triangles; ++id) {
    const glm::vec3 a(coordinate(), coordinate(), coordinate());
    const glm::vec3 reach(static_cast<float>(random() % 5), static_cast<float>(random() % 5),
                          static_cast<float>(random() % 5));
    const glm::vec3 b = id == 0 ? glm::vec3(0) : glm::min(a + reach, glm::vec3(12));
    const glm::vec3 c = id == 1 ? glm::vec3(12) : a;
    small.mesh.positions.insert(small.mesh.positions.end(), {id == 0 ? glm::vec3(1) : a, b, c});
    small.mesh.triangles.emplace_back(3 * id, 3 * id + 1, 3 * id + 2);
  }
  const std::vector<Box> boxes = triangle_boxes(small.mesh);
  for (std::uint32_t id = 0; id < triangles; ++id) small.pieces.push_back({boxes[id], id});
  small.cell = box_of(small.pieces);
  return small;
}

bool inside(const Box& outer, const Box& inner) {
  for (int axis = 0; axis < 3; ++axis) {
    if (inner.lower[axis] < outer.lower[axis] || inner.upper[axis] > outer.upper[axis]) return false;
  }
  return true;
}

/// The cheapest of all pairs of boxes on the grid, both orders of each, gaps and all. What is split, SideRule says.
double cheapest_on_grid(const Small& small, const std::array<int, 3>& cells, double overlap, bool may_split) {
  std::vector<Box> boxes;
  const auto at = [&](int axis, int i) {
    const int count = cells[static_cast<std::size_t>(axis)];
    return static_cast<float>(small.cell.lower[axis] + (small.cell.upper[axis] - small.cell.lower[axis]) *
                                                           static_cast<float>(i) / static_cast<float>(count));
  };
  for (int x = 0; x < cells[0]; ++x)
    for (int x2 = x + 1; x2 <= cells[0]; ++x2)
      for (int y = 0; y < cells[1]; ++y)
        for (int y2 = y + 1; y2 <= cells[1]; ++y2)
          for (int z = 0; z < cells[2]; ++z)
            for (int z2 = z + 1; z2 <= cells[2]; ++z2)
              boxes.push_back({{at(0, x), at(1, y), at(2, z)}, {at(0, x2), at(1, y2), at(2, z2)}});
  double best = INFINITY;
  for (const Box& a : boxes) {
    for (const Box& b : boxes) {
      const bool smaller = half_area(a) <= half_area(b);
      int left = 0;
      int right = 0;
      bool feasible = true;
      for (const Piece& piece : small.pieces) {
        const bool in_a = inside(a, piece.box);
        const bool in_b = inside(b, piece.box);
        const bool split =
            may_split && !in_a && !in_b && SideRule({a, b}, true).side_of(piece, small.mesh) == Side::both;
        feasible = feasible && (in_a || in_b || split);
        left += split || (in_a && (!in_b || smaller)) ? 1 : 0;
        right += split || (in_b && (!in_a || !smaller)) ? 1 : 0;
      }
      if (!feasible || left == 0 || right == 0) continue;
      double common = 1;
      double all = 1;
      for (int axis = 0; axis < 3; ++axis) {
        common *= std::max(0.0F, std::min(a.upper[axis], b.upper[axis]) - std::max(a.lower[axis], b.lower[axis]));
        all *= small.cell.upper[axis] - small.cell.lower[axis];
      }
      best = std::min(best, (half_area(a) * left + half_area(b) * right) * (1 + overlap * common / all));
    }
  }
  return best;
}

TEST(GridOracle, the_search_finds_the_cheapest_of_all_boxes_on_the_grid) {
  std::mt19937 random(4);
  std::size_t found = 0;
  std::size_t split = 0;
  for (int round = 0; round < 60; ++round) {
    const Small small = random_small(random, 3 + static_cast<std::uint32_t>(random() % 10));
    SearchRules rules;
    rules.centroids = false;
    rules.grid = true;
    rules.may_split = round % 2 == 0;
    rules.overlap = round % 3 == 0 ? 0 : 1.0 * (round % 3);
    const double cells = 30;
    rules.resolution = cells * cells / static_cast<double>(small.pieces.size());
    const GridOracle oracle(small.cell, cells);
    const std::array<int, 3> resolution = oracle.resolution();
    ASSERT_EQ(resolution, (std::array<int, 3>{3, 3, 3}));
    const auto partitions = cheapest_partitions(small.pieces, small.cell, small.mesh, rules);
    const double wanted = cheapest_on_grid(small, resolution, rules.overlap, rules.may_split);
    ASSERT_EQ(partitions.empty(), wanted == INFINITY);
    if (partitions.empty()) continue;
    ASSERT_DOUBLE_EQ(partitions.front().cost, wanted) << round;
    ++found;
    const ChildBoxes& best = partitions.front().boxes;
    split += best.count[0] + best.count[1] > small.pieces.size() ? 1 : 0;
  }
  EXPECT_GT(found, 40U);
  EXPECT_GT(split, 3U);
}

TEST(GridOracle, cells_are_no_more_than_asked_for_and_follow_the_extents) {
  const auto resolution = [](const glm::vec3& size, double cells) {
    return GridOracle({glm::vec3(0), size}, cells).resolution();
  };
  EXPECT_EQ(resolution({1, 1, 1}, 64), (std::array<int, 3>{4, 4, 4}));
  EXPECT_EQ(resolution({4, 2, 1}, 64), (std::array<int, 3>{8, 4, 2}));
  EXPECT_EQ(resolution({1, 1, 0}, 9), (std::array<int, 3>{3, 3, 1}));
  EXPECT_EQ(resolution({0, 0, 0}, 100), (std::array<int, 3>{1, 1, 1}));
  EXPECT_EQ(resolution({1, 0, 0}, 1e9), (std::array<int, 3>{64, 1, 1}));
}

TEST(Search, keeps_the_cheapest_in_order_of_cost) {
  std::mt19937 random(6);
  for (int round = 0; round < 40; ++round) {
    const Small small = random_small(random, 12);
    SearchRules rules;
    rules.planes = rules.grid = true;
    rules.resolution = 60;
    rules.most = 1000000;
    const auto all = cheapest_partitions(small.pieces, small.cell, small.mesh, rules);
    ASSERT_GT(all.size(), 30U);
    for (std::size_t i = 1; i < all.size(); ++i) ASSERT_LE(all[i - 1].cost, all[i].cost);
    for (const std::size_t most : {std::size_t{1}, std::size_t{7}}) {
      rules.most = most;
      const auto some = cheapest_partitions(small.pieces, small.cell, small.mesh, rules);
      ASSERT_EQ(some.size(), most);
      for (std::size_t i = 0; i < most; ++i) {
        ASSERT_EQ(some[i].cost, all[i].cost);
        ASSERT_EQ(some[i].kind, all[i].kind);
      }
    }
  }
}

/// Equation 1 over the whole of a tree split in the middle, by areas.
double naive_middle_cost(const std::vector<Box>& boxes, std::size_t leaf, double traversal, double intersection) {
  Box around = boxes[0];
  for (const Box& box : boxes) around = unite(around, box);
  const double as_leaf = intersection * static_cast<double>(boxes.size()) * half_area(around);
  const auto centroid = [](const Box& box, int axis) { return box.lower[axis] * 0.5F + box.upper[axis] * 0.5F; };
  int axis = 0;
  float longest = -1;
  float middle = 0;
  for (int a = 0; a < 3; ++a) {
    float least = INFINITY;
    float most = -INFINITY;
    for (const Box& box : boxes) {
      least = std::min(least, centroid(box, a));
      most = std::max(most, centroid(box, a));
    }
    if (most - least > longest) {
      longest = most - least;
      axis = a;
      middle = least * 0.5F + most * 0.5F;
    }
  }
  std::vector<Box> left;
  std::vector<Box> right;
  for (const Box& box : boxes) (centroid(box, axis) < middle ? left : right).push_back(box);
  if (left.empty()) return as_leaf;
  const double split = traversal * half_area(around) + naive_middle_cost(left, leaf, traversal, intersection) +
                       naive_middle_cost(right, leaf, traversal, intersection);
  return boxes.size() <= leaf ? std::min(as_leaf, split) : split;
}

TEST(MiddleSplit, the_expected_cost_of_subtrees_is_equation_1s) {
  std::mt19937 random(8);
  for (int round = 0; round < 100; ++round) {
    Small small = random_small(random, 2 + static_cast<std::uint32_t>(random() % 40));
    std::vector<Box> boxes;
    for (const Piece& piece : small.pieces) boxes.push_back(piece.box);
    BuildLimits limits;
    limits.leaf = 1 + random() % 6;
    limits.intersection = 1.5;
    ASSERT_EQ(middle_split_cost(small.pieces, limits), naive_middle_cost(boxes, limits.leaf, 1, 1.5));
  }
}

TEST(MiddleSplit, nothing_tells_pieces_apart_that_all_lie_below_a_middle_of_subnormals) {
  const float least = std::numeric_limits<float>::denorm_min();
  const Box box{glm::vec3(2 * least), glm::vec3(4 * least)};  // its centroid is 3 of them, whose halves round to 2
  std::vector<Piece> pieces{{box, 0}, {box, 1}};
  EXPECT_EQ(split_in_middle(pieces), 0U);
}

/// Figure 1: boxes of two sizes around one point, taking turns.
Mesh nested() {
  Mesh mesh;
  mesh.name = "nested";
  for (std::uint32_t i = 0; i < 32; ++i) {
    const float size = i % 2 == 0 ? 1 : 10;
    mesh.positions.insert(mesh.positions.end(), {glm::vec3(-size), glm::vec3(size), glm::vec3(-size, size, -size)});
    mesh.triangles.emplace_back(3 * i, 3 * i + 1, 3 * i + 2);
  }
  return mesh;
}

TEST(Geometric, nests_siblings_where_all_centroids_are_one) {
  const Mesh mesh = nested();
  const FloatTree nesting = build("geometric,resolution=64,leaf=16", mesh);
  const FloatPair& root = nesting.pairs.back();
  EXPECT_EQ(std::min(half_area(root.child[0]), half_area(root.child[1])), 12);
  EXPECT_LT(sah(nesting), 0.7 * sah(build("sweep,leaf=16", mesh)));
}

double common_volume(const FloatTree& tree) {
  double sum = 0;
  for (const FloatPair& pair : tree.pairs) {
    double common = 1;
    for (int axis = 0; axis < 3; ++axis)
      common *= std::max(0.0, static_cast<double>(std::min(pair.child[0].upper[axis], pair.child[1].upper[axis])) -
                                  static_cast<double>(std::max(pair.child[0].lower[axis], pair.child[1].lower[axis])));
    sum += common;
  }
  return sum;
}

TEST(Generic, the_penalty_on_overlap_takes_the_overlap_away) {
  const Mesh mesh = load_scene("rotated:proc:city,triangles=600");
  const double none = common_volume(build("generic", mesh));
  const double some = common_volume(build("generic,overlap=10", mesh));
  const double most = common_volume(build("generic,overlap=1e16", mesh));
  EXPECT_LT(some, none);
  EXPECT_LT(most, some);
}

TEST(Generic, keeps_to_its_budget_of_references_and_refuses_what_it_cannot_do) {
  const Mesh mesh = load_scene("rotated:proc:city,triangles=300");
  const std::size_t triangles = mesh.triangles.size();
  ASSERT_GT(build("generic,overlap=1e16", mesh).primitive_ids.size(), 3 * triangles / 2);
  for (const double factor : {1.0, 1.2}) {
    const auto budget = static_cast<std::size_t>(factor * static_cast<double>(triangles));
    const FloatTree tree = build(fmt::format("generic,overlap=1e16,references={}", budget), mesh);
    EXPECT_LE(tree.primitive_ids.size(), budget);
    EXPECT_TRUE(check_tree(tree, mesh).empty());
  }
  EXPECT_EQ(build("geometric", mesh).primitive_ids.size(), triangles);
  for (const std::string& refused :
       {fmt::format("generic,references={}", triangles - 1), std::string("generic,oracle=octree"),
        std::string("generic,overlap=-1"), std::string("geometric,resolution=1e9")})
    EXPECT_THROW(build(refused, mesh), InputError) << refused;
}

}  // namespace
}  // namespace cbvh::golden
