// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// Which of two boxes a triangle goes into, and counting that with a tree.
#include "golden/build/count_tree.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "golden/tree/coverage.h"

namespace cbvh::golden {
namespace {

struct Scene {
  Mesh mesh;
  std::vector<Piece> pieces;
};

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  std::uint32_t below(std::uint32_t bound) { return static_cast<std::uint32_t>(engine_() % bound); }
  glm::vec3 point(std::uint32_t bound) {
    const auto coordinate = [&] { return static_cast<float>(below(bound)); };
    const float x = coordinate();
    const float y = coordinate();
    return {x, y, coordinate()};
  }

 private:
  std::mt19937 engine_;
};

Scene random_scene(Random& random, std::uint32_t triangles, std::uint32_t size) {
  Scene scene;
  for (std::uint32_t id = 0; id < triangles; ++id) {
    const glm::vec3 at = random.point(9 - size);
    for (int corner = 0; corner < 3; ++corner) scene.mesh.positions.push_back(at + random.point(size + 1));
    scene.mesh.triangles.emplace_back(3 * id, 3 * id + 1, 3 * id + 2);
  }
  const std::vector<Box> boxes = triangle_boxes(scene.mesh);
  for (std::uint32_t id = 0; id < triangles; ++id) scene.pieces.push_back({boxes[id], id});
  return scene;
}

/// Two boxes that now and then hold everything, their other sides beside whole numbers.
std::array<Box, 2> random_boxes(Random& random, float beside = 0) {
  std::array<Box, 2> boxes{};
  for (int axis = 0; axis < 3; ++axis) {
    for (Box& box : boxes) {
      box.lower[axis] = random.below(2) == 0 ? 0 : static_cast<float>(random.below(5)) + beside;
      box.upper[axis] = random.below(2) == 0 ? 9 : static_cast<float>(4 + random.below(6)) - beside;
    }
  }
  return boxes;
}

bool inside(const Box& outer, const Box& inner) {
  for (int axis = 0; axis < 3; ++axis) {
    if (inner.lower[axis] < outer.lower[axis] || inner.upper[axis] > outer.upper[axis]) return false;
  }
  return true;
}

/// Section 3.1's rule for triangles that may not be split; from its words.
Side whole_side(const Box& triangle, const std::array<Box, 2>& boxes) {
  const bool first = inside(boxes[0], triangle);
  const bool second = inside(boxes[1], triangle);
  if (first && second) return half_area(boxes[0]) <= half_area(boxes[1]) ? Side::first : Side::second;
  if (first) return Side::first;
  return second ? Side::second : Side::nowhere;
}

/// Whether both boxes together hold all of the triangle, in rational arithmetic.
bool covered(const Scene& scene, std::uint32_t id, const std::array<Box, 2>& boxes) {
  Mesh one;
  one.positions = scene.mesh.positions;
  one.triangles = {scene.mesh.triangles[id]};
  FloatTree tree;
  tree.pairs = {{{boxes[0], boxes[1]}, {true, true}, {0, 1}}};
  tree.primitive_ids = {kLastOfLeaf, kLastOfLeaf};
  return coverage_gaps(tree, one).empty();
}

TEST(SideRule, a_triangle_is_split_only_between_boxes_that_together_hold_all_of_it) {
  Random random(1);
  std::size_t both = 0;
  std::size_t refused = 0;
  for (int round = 0; round < 1500; ++round) {
    const Scene scene = random_scene(random, 4, 6);
    const bool on_lattice = round % 2 == 0;  // where rounding may refuse what just fits
    const std::array<Box, 2> boxes = random_boxes(random, on_lattice ? 0 : 0.37F);
    for (const Piece& piece : scene.pieces) {
      const Side whole = whole_side(piece.box, boxes);
      ASSERT_EQ(SideRule(boxes, false).side_of(piece, scene.mesh), whole);
      const Side side = SideRule(boxes, true).side_of(piece, scene.mesh);
      if (whole != Side::nowhere) {
        ASSERT_EQ(side, whole);
        continue;
      }
      const bool holds = covered(scene, piece.id, boxes);
      if (side == Side::both) {
        ASSERT_TRUE(holds) << "round " << round;
        ++both;
      } else {
        ASSERT_EQ(side, Side::nowhere);
        refused += holds && !on_lattice ? 1 : 0;
      }
    }
  }
  EXPECT_GT(both, 200U);
  EXPECT_EQ(refused, 0U);
}

TEST(CountTree, counts_what_asking_every_piece_counts) {
  Random random(2);
  std::size_t counted = 0;
  std::size_t rejected = 0;
  for (int round = 0; round < 60; ++round) {
    const Scene scene = random_scene(random, 1 + random.below(70), 1 + random.below(3));
    CountTree tree(scene.pieces, scene.mesh);
    for (int tried = 0; tried < 100; ++tried) {
      ChildBoxes children{random_boxes(random), {}};
      for (const bool may_split : {false, true}) {
        std::array<std::uint32_t, 2> wanted{};
        bool feasible = true;
        for (const Piece& piece : scene.pieces) {
          Side side = whole_side(piece.box, children.box);
          if (side == Side::nowhere && may_split) side = SideRule(children.box, true).side_of(piece, scene.mesh);
          feasible = feasible && side != Side::nowhere;
          wanted[0] += side == Side::first || side == Side::both ? 1 : 0;
          wanted[1] += side == Side::second || side == Side::both ? 1 : 0;
        }
        constexpr double kAny = std::numeric_limits<double>::infinity();
        ASSERT_EQ(tree.count(children, may_split, kAny), feasible) << round;
        if (!feasible) {
          ++rejected;
          continue;
        }
        ++counted;
        ASSERT_EQ(children.count, wanted) << round;
        const double cost = half_area(children.box[0]) * wanted[0] + half_area(children.box[1]) * wanted[1];
        ASSERT_TRUE(tree.count(children, may_split, cost + 1));
        ASSERT_EQ(children.count, wanted);
        ASSERT_FALSE(tree.count(children, may_split, cost / 2));
      }
    }
  }
  EXPECT_GT(counted, 1000U);
  EXPECT_GT(rejected, 1000U);
}

}  // namespace
}  // namespace cbvh::golden
