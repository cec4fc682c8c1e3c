// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/build/check_tree.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "golden/build/lbvh.h"
#include "golden/scene/load.h"
#include "golden/scene/trouble_scenes.h"

namespace cbvh::golden {
namespace {

TEST(CheckTree, finds_nothing_in_the_trees_of_a_builder) {
  for (std::uint64_t id = 0; id < 120; ++id) {
    const Mesh mesh = trouble_scene(kTroubles[id % kTroubles.size()], id);
    EXPECT_EQ(check_tree(build_lbvh(mesh), mesh), std::vector<std::string>()) << id;
  }
}

/// A tree with a leaf of two triangles, broken in one place.
std::string finding(const std::function<void(FloatTree&)>& damage) {
  const Mesh mesh = load_scene("proc:cloth");
  FloatTree tree = build_lbvh(mesh);
  damage(tree);
  const std::vector<std::string> found = check_tree(tree, mesh, 1);
  return found.empty() ? "" : found.front();
}

std::size_t first_of_a_leaf_of_two(const FloatTree& tree) {
  std::size_t entry = 0;
  while ((tree.primitive_ids[entry] & kLastOfLeaf) != 0) ++entry;
  return entry;
}

std::size_t pair_with_inner_children(const FloatTree& tree) {
  std::size_t pair = 0;
  while (tree.pairs[pair].leaf[0] || tree.pairs[pair].leaf[1]) ++pair;
  return pair;
}

TEST(CheckTree, finds_what_is_wrong_and_says_where) {
  EXPECT_EQ(finding([](FloatTree&) {}), "");
  EXPECT_EQ(finding([](FloatTree& tree) { --tree.primitives; }), "64999 primitives, the mesh has 65000");
  EXPECT_NE(finding([](FloatTree& tree) { ++tree.leaves; }).find("leaves for"), std::string::npos);
  EXPECT_NE(finding([](FloatTree& tree) {
              FloatPair& pair = tree.pairs[pair_with_inner_children(tree)];
              std::swap(pair.pointer[0], pair.pointer[1]);
            }).find(", child 0: pair"),
            std::string::npos);
  EXPECT_NE(finding([](FloatTree& tree) {
              float& edge = tree.pairs[pair_with_inner_children(tree)].child[1].upper.y;
              edge = std::nextafter(edge, INFINITY);
            }).find("child 1: its box is not exactly around its children"),
            std::string::npos);
  EXPECT_NE(finding([](FloatTree& tree) {
              float& edge = tree.pairs[0].child[0].lower.x;
              edge = std::nextafter(edge, INFINITY);
            }).find("its box is not exactly"),
            std::string::npos);
  EXPECT_EQ(finding([](FloatTree& tree) { tree.scene.upper.z += 1; }),
            "the scene's box is not exactly around the root's children");
  EXPECT_NE(finding([](FloatTree& tree) {
              const std::size_t entry = first_of_a_leaf_of_two(tree);
              tree.primitive_ids[entry] = tree.primitive_ids[entry + 1] & ~kLastOfLeaf;
            }).find("a second time"),
            std::string::npos);
  EXPECT_NE(
      finding([](FloatTree& tree) { tree.primitive_ids.back() = 65000 | kLastOfLeaf; }).find("wanted below 65000"),
      std::string::npos);
  EXPECT_NE(finding([](FloatTree& tree) { tree.primitive_ids.back() &= ~kLastOfLeaf; }).find("its leaf has no end"),
            std::string::npos);
  EXPECT_NE(
      finding([](FloatTree& tree) { tree.primitive_ids[first_of_a_leaf_of_two(tree)] |= kLastOfLeaf; }).find("wanted"),
      std::string::npos);
}

TEST(CheckTree, lets_leaves_share_a_triangle_but_not_reach_beyond_it) {
  const Mesh mesh{"two", {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {9, 0, 0}, {9, 1, 0}, {8, 0, 1}}, {{0, 1, 2}, {3, 4, 5}}};
  const std::vector<Box> boxes = triangle_boxes(mesh);
  FloatTree tree = build_lbvh(mesh);
  ASSERT_EQ(check_tree(tree, mesh), std::vector<std::string>());
  tree.primitive_ids = {0 | kLastOfLeaf, 0, 1 | kLastOfLeaf};
  tree.pairs[0] = {{{{0, 0, 0}, {2, 4, 0}}, unite({{2, 0, 0}, {4, 2, 0}}, boxes[1])}, {true, true}, {0, 1}};
  EXPECT_EQ(check_tree(tree, mesh), std::vector<std::string>());
  tree.pairs[0].child[0].upper.z = 1;
  EXPECT_EQ(check_tree(tree, mesh),
            (std::vector<std::string>{"pair 0, child 0: its box is not within its triangles'"}));
  tree.pairs[0].child[0].upper.z = 0;
  tree.primitive_ids = {0 | kLastOfLeaf, 0, 0 | kLastOfLeaf};
  EXPECT_EQ(check_tree(tree, mesh).back(), "triangle 1 is in no leaf");
}

}  // namespace
}  // namespace cbvh::golden
