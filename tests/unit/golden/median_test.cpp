// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/build/median.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "golden/build/top_grid.h"
#include "golden/scene/trouble_scenes.h"
#include "tests/unit/golden/built_tree_checks.h"
#include "tests/unit/golden/naive_sah.h"

namespace cbvh::golden {
namespace {

/// Halves boxes of centroids from their definition: `grid` times whatever lies in them, then each subtree on its own,
/// shrinking a box of which a half is empty.
class NaiveMedian : public NaiveSah {
 public:
  FloatTree build(const Mesh& mesh, int grid) {
    boxes = triangle_boxes(mesh);
    Ids all(boxes.size());
    for (std::uint32_t id = 0; id < all.size(); ++id) all[id] = id;
    in_grid(all, centroids(all), grid, depth);
    tree_.leaves = static_cast<std::uint32_t>(tree_.pairs.size() + 1);
    return tree_;
  }

 private:
  Box centroids(const Ids& ids) const {
    Box box;
    for (int axis = 0; axis < 3; ++axis) {
      const Ids order = sorted(ids, axis);
      box.lower[axis] = centroid(order.front(), axis);
      box.upper[axis] = centroid(order.back(), axis);
    }
    return box;
  }

  struct Halved {
    Halves ids;
    Box left;
    Box right;
  };
  Halved halve(const Ids& ids, const Box& region) const {
    int axis = 0;
    for (int a = 1; a < 3; ++a) {
      if (static_cast<double>(region.upper[a]) - static_cast<double>(region.lower[a]) >
          static_cast<double>(region.upper[axis]) - static_cast<double>(region.lower[axis]))
        axis = a;
    }
    const float middle = region.lower[axis] * 0.5F + region.upper[axis] * 0.5F;
    Halved halved{{}, region, region};
    halved.left.upper[axis] = halved.right.lower[axis] = middle;
    for (const std::uint32_t id : ids) (centroid(id, axis) < middle ? halved.ids.left : halved.ids.right).push_back(id);
    return halved;
  }

  bool fit(const Halves& halves, int levels) const {
    const std::size_t larger = std::max(halves.left.size(), halves.right.size());
    return larger <= leaf << static_cast<unsigned>(levels - 1);
  }

  Emitted in_grid(const Ids& ids, const Box& region, int grid, int levels) {
    if (grid == 0 || ids.size() <= leaf) return alone(ids, centroids(ids), levels);
    const Halved halved = halve(ids, region);
    if (halved.ids.left.empty()) return in_grid(ids, halved.right, grid - 1, levels);
    if (halved.ids.right.empty()) return in_grid(ids, halved.left, grid - 1, levels);
    if (!fit(halved.ids, levels)) return alone(ids, centroids(ids), levels);
    const Emitted left = in_grid(halved.ids.left, halved.left, grid - 1, levels - 1);
    return emit_pair(left, in_grid(halved.ids.right, halved.right, grid - 1, levels - 1), tree_);
  }

  Emitted alone(const Ids& ids, const Box& region, int levels) {
    Halved halved = halve(ids, region);
    if (halved.ids.left.empty() || halved.ids.right.empty()) halved = halve(ids, centroids(ids));
    const bool none = halved.ids.left.empty() || halved.ids.right.empty();
    if (is_leaf(ids, levels, none ? std::numeric_limits<double>::infinity() : cost(halved.ids)))
      return emit_leaf(ids, tree_);
    if (none || area(ids) == 0 || !fit(halved.ids, levels)) {
      halved.ids = median(ids);
      halved.left = centroids(halved.ids.left);
      halved.right = centroids(halved.ids.right);
    }
    const Emitted left = alone(halved.ids.left, halved.left, levels - 1);
    return emit_pair(left, alone(halved.ids.right, halved.right, levels - 1), tree_);
  }

  FloatTree tree_;
};

TEST(Median, equals_the_naive_builder_on_every_kind_of_trouble) {
  std::size_t pairs = 0;
  for (std::uint64_t id = 0; id < 360; ++id) {
    const Mesh mesh = trouble_scene(kTroubles[id % kTroubles.size()], id, 100);
    NaiveMedian naive;
    naive.leaf = 1 + id % 5;
    naive.depth = 7 + static_cast<int>(id % 5);
    naive.traversal = static_cast<double>(id % 4) * 0.5;
    naive.intersection = 1 + static_cast<double>(id % 3);
    const std::string builder = fmt::format("median,leaf={},depth={},traversal={},intersection={}", naive.leaf,
                                            naive.depth, naive.traversal, naive.intersection);
    const FloatTree tree = build(builder, mesh);
    expect_same_tree(tree, naive.build(mesh, 0), mesh.name + " " + builder);
    if (HasFatalFailure()) return;
    pairs += tree.pairs.size();
  }
  EXPECT_GT(pairs, 5'000U);
}

TEST(Median, its_grid_halves_the_scene_as_nodes_do) {
  // Points on a lattice of exact halves; opposite corners make the extents powers of two.
  Mesh mesh{"lattice", {{0, 0, 0}, {4, 8, 2}}, {{0, 0, 0}, {1, 1, 1}}};
  std::uint64_t state = 5;
  while (mesh.triangles.size() < 16 * kTrianglesPerCell + 7) {
    state = state * 6364136223846793005U + 1442695040888963407U;
    const auto lattice = [&](int shift, unsigned steps) { return static_cast<float>((state >> shift) % steps) / 16; };
    const glm::vec3 at(lattice(20, 64), lattice(32, 40), lattice(44, 32));  // y: nothing in the last three eighths
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (const float step : {0.0F, 0.0625F}) mesh.positions.push_back(at + step);
    mesh.triangles.emplace_back(first, first + 1, first);
  }
  for (const int depth_limit : {32, 10}) {
    NaiveMedian naive;
    naive.depth = depth_limit;
    const FloatTree tree = build(fmt::format("median,depth={}", depth_limit), mesh);
    expect_same_tree(tree, naive.build(mesh, 5), mesh.name);
  }
}

TEST(Median, trees_of_trouble_are_tight_within_their_depth_and_stream_as_top_down) {
  for (std::uint64_t id = 0; id < 96; ++id) {
    const Mesh mesh = trouble_scene(kTroubles[id % kTroubles.size()], id, 600);
    for (const char* builder : {"median,depth=10,leaf=2", "binned,top=grid,depth=10,leaf=2"}) {
      const FloatTree tree = build(builder, mesh);
      expect_tree_of_all_triangles(tree, mesh, 2, 10);
      expect_streams_as_top_down(tree, mesh.name);
      if (HasFatalFailure()) return;
    }
  }
}

}  // namespace
}  // namespace cbvh::golden
