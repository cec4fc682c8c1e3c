// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// Builders that split triangles: planes, clipping, coverage, budgets.
#include "golden/build/spatial.h"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <random>

#include "built_tree_checks.h"
#include "golden/build/clip.h"
#include "golden/build/plane_sweep.h"
#include "golden/input_error.h"
#include "golden/scene/load.h"
#include "golden/scene/trouble_scenes.h"
#include "golden/tree/coverage.h"
#include "golden/tree/sah.h"

namespace cbvh::golden {
namespace {

const char* const kSplitters[] = {"spatial", "spatial,objects=1", "spatial,tight=1,leaf=1", "kdtree", "kdtree,leaf=2"};

TEST(Spatial, trees_of_trouble_cover_every_triangle_exactly_and_stream_as_top_down) {
  std::size_t shared = 0;
  for (std::uint64_t id = 0; id < 36; ++id) {
    const Mesh mesh = trouble_scene(kTroubles[id % kTroubles.size()], id, 14);
    for (const char* const builder : kSplitters) {
      const FloatTree tree = build(builder, mesh);
      const std::string name = fmt::format("{} {}", builder, id);
      for (const std::string& finding : check_tree(tree, mesh)) ADD_FAILURE() << name << ": " << finding;
      for (const CoverageGap& gap : coverage_gaps(tree, mesh))
        ADD_FAILURE() << name << ": triangle " << gap.triangle << " at " << gap.witness[0];
      EXPECT_LE(depth(tree), 32);
      expect_streams_as_top_down(tree, name);
      shared += tree.primitive_ids.size() > tree.primitives ? 1 : 0;
    }
  }
  EXPECT_GT(shared, 40U);
}

TEST(Spatial, trees_of_larger_scenes_cover_and_are_the_same_every_time) {
  for (const char* const scene :
       {"rotated:proc:city,triangles=134", "proc:hairball,triangles=100", "proc:soup,triangles=40,size=0.4"}) {
    const Mesh mesh = load_scene(scene);
    for (const char* const builder : kSplitters) {
      const FloatTree tree = build(builder, mesh);
      EXPECT_TRUE(check_tree(tree, mesh).empty());
      EXPECT_TRUE(coverage_gaps(tree, mesh, 37).empty());
      expect_same_tree(build(builder, mesh), tree, scene);
    }
  }
}

TEST(Spatial, splitting_pays_on_triangles_across_the_axes) {
  const Mesh mesh = load_scene("rotated:proc:city,triangles=3000");
  EXPECT_LT(sah(build("spatial", mesh)), 0.9 * sah(build("sweep", mesh)));
}

TEST(Coverage, finds_what_no_leaf_holds) {
  const Mesh mesh = load_scene("rotated:proc:city,triangles=14");
  FloatTree tree = build("spatial", mesh);
  ASSERT_TRUE(coverage_gaps(tree, mesh).empty());
  std::size_t tried = 0;
  std::size_t found = 0;
  for (std::size_t i = 0; i < tree.pairs.size(); i += 5) {
    for (int c = 0; c < 2; ++c) {
      if (!tree.pairs[i].leaf[c]) continue;
      float& upper = tree.pairs[i].child[c].upper.x;
      const float whole = upper;
      upper = std::nextafter(whole, -INFINITY);
      found += coverage_gaps(tree, mesh).empty() ? 0 : 1;
      upper = whole;
      ++tried;
    }
  }
  EXPECT_GT(tried, 10U);
  EXPECT_GT(found, tried / 4) << "boxes are not much larger than what they hold";
}

/// All of the plane's candidates, counted piece by piece.
double cheapest_by_counting(const std::vector<Piece>& pieces, const Box& cell) {
  double best = INFINITY;
  for (int axis = 0; axis < 3; ++axis) {
    for (const Piece& source : pieces) {
      for (const float plane : {source.box.lower[axis], source.box.upper[axis]}) {
        for (const bool planar_left : {true, false}) {
          double left = 0;
          double right = 0;
          for (const Piece& piece : pieces) {
            const bool planar = piece.box.lower[axis] == plane && piece.box.upper[axis] == plane;
            left += piece.box.lower[axis] < plane || (planar && planar_left) ? 1 : 0;
            right += piece.box.upper[axis] > plane || (planar && !planar_left) ? 1 : 0;
          }
          if (left == 0 || right == 0) continue;
          Box low = cell;
          Box high = cell;
          low.upper[axis] = high.lower[axis] = plane;
          best = std::min(best, half_area(low) * left + half_area(high) * right);
        }
      }
    }
  }
  return best;
}

TEST(PlaneSweep, finds_the_cheapest_plane_of_all_and_counts_its_sides) {
  std::mt19937 random(3);
  std::size_t splits = 0;
  for (int round = 0; round < 300; ++round) {
    std::vector<Piece> pieces;
    const auto coordinate = [&] { return static_cast<float>(random() % 9); };
    for (std::uint32_t i = 0; i < 2 + random() % 12; ++i) {
      const glm::vec3 a(coordinate(), coordinate(), coordinate());
      const glm::vec3 b(coordinate(), coordinate(), coordinate());
      pieces.push_back({unite({a, a}, {b, b}), i});
    }
    Box cell = pieces.front().box;
    for (const Piece& piece : pieces) cell = unite(cell, piece.box);
    const PlaneSplit split = best_plane(pieces, cell, false);
    const double wanted = cheapest_by_counting(pieces, cell);
    ASSERT_EQ(split.exists(), wanted < INFINITY);
    if (!split.exists()) continue;
    ASSERT_EQ(split.cost, wanted);
    std::uint32_t left = 0;
    std::uint32_t right = 0;
    for (const Piece& piece : pieces) {
      ASSERT_TRUE(split.goes_left(piece.box) || split.goes_right(piece.box));
      left += split.goes_left(piece.box) ? 1 : 0;
      right += split.goes_right(piece.box) ? 1 : 0;
    }
    ASSERT_EQ(split.left, left);
    ASSERT_EQ(split.right, right);
    ++splits;
  }
  EXPECT_GT(splits, 200U);
}

TEST(Clip, the_box_holds_every_point_of_the_triangle_within_and_no_more_than_rounding_adds) {
  using Rational = boost::multiprecision::cpp_rational;
  std::mt19937 random(5);
  const auto coordinate = [&] { return static_cast<float>(random() % 4096) / 512.0F - 4.0F; };
  const auto point = [&] { return glm::vec3(coordinate(), coordinate(), coordinate()); };
  std::size_t inside = 0;
  for (int round = 0; round < 3000; ++round) {
    const Corners triangle{point(), point(), point()};
    const glm::vec3 a = point();
    const glm::vec3 b = point();
    const Box within = unite({a, a}, {b, b});
    const std::optional<Box> box = clipped_box(triangle, within);
    for (int sample = 0; sample < 20; ++sample) {
      const int u = static_cast<int>(random() % 65);
      const int v = static_cast<int>(random() % static_cast<unsigned>(65 - u));
      std::array<Rational, 3> p;
      bool in = true;
      for (int axis = 0; axis < 3; ++axis) {
        const auto at = static_cast<std::size_t>(axis);
        p[at] = (Rational(triangle[0][axis]) * u + Rational(triangle[1][axis]) * v +
                 Rational(triangle[2][axis]) * (64 - u - v)) /
                64;
        in = in && p[at] >= Rational(within.lower[axis]) && p[at] <= Rational(within.upper[axis]);
      }
      if (!in) continue;
      ASSERT_TRUE(box) << "round " << round;
      for (int axis = 0; axis < 3; ++axis) {
        const auto at = static_cast<std::size_t>(axis);
        ASSERT_TRUE(Rational(box->lower[axis]) <= p[at] && p[at] <= Rational(box->upper[axis])) << "round " << round;
      }
      ++inside;
    }
    for (int axis = 0; box && axis < 3; ++axis) {
      ASSERT_GE(box->lower[axis], within.lower[axis]);
      ASSERT_LE(box->upper[axis], within.upper[axis]);
    }
  }
  EXPECT_GT(inside, 2000U);
  // By hand: the triangle (0,0,0) (4,0,0) (0,4,0) below x = 1 reaches from y = 0 to 4, above x = 1 to y = 3.
  const Corners triangle{glm::vec3(0), glm::vec3(4, 0, 0), glm::vec3(0, 4, 0)};
  const std::optional<Box> high = clipped_box(triangle, {{1, 0, 0}, {4, 4, 0}});
  ASSERT_TRUE(high);
  EXPECT_EQ(high->lower, glm::vec3(1, 0, 0));
  EXPECT_EQ(high->upper.x, 4);
  EXPECT_GE(high->upper.y, 3);
  EXPECT_LE(high->upper.y, std::nextafter(3.0F, 4.0F));
  EXPECT_FALSE(clipped_box(triangle, {{3, 3, 0}, {4, 4, 0}}));
}

TEST(Spatial, keeps_to_its_budget_of_references_and_refuses_one_that_is_too_small) {
  const Mesh mesh = load_scene("rotated:proc:city,triangles=600");
  const std::size_t triangles = mesh.triangles.size();
  const std::size_t free = build("spatial", mesh).primitive_ids.size();
  ASSERT_GT(free, 2 * triangles);
  std::size_t last = 0;
  for (const double factor : {1.0, 1.1, 1.5, 2.0}) {
    const auto budget = static_cast<std::size_t>(factor * static_cast<double>(triangles));
    const FloatTree tree = build(fmt::format("spatial,references={}", budget), mesh);
    EXPECT_LE(tree.primitive_ids.size(), budget);
    EXPECT_GE(tree.primitive_ids.size(), last);
    EXPECT_TRUE(check_tree(tree, mesh).empty());
    EXPECT_TRUE(coverage_gaps(tree, mesh, 97).empty());
    last = tree.primitive_ids.size();
  }
  try {
    build(fmt::format("kdtree,references={}", triangles - 1), mesh);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()), fmt::format("{}: {} triangles, but at most {} references are allowed",
                                                     mesh.name, triangles, triangles - 1));
  }
}

}  // namespace
}  // namespace cbvh::golden
