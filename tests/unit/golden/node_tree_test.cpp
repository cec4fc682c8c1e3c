// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/build/node_tree.h"

#include <gtest/gtest.h>

#include "golden/build/builder.h"
#include "golden/input_error.h"

namespace cbvh::golden {
namespace {

Box cube(float at) { return {glm::vec3(at), glm::vec3(at + 1)}; }

TEST(NodeTree, is_emitted_depth_first_and_bottom_up_whatever_the_order_of_its_nodes) {
  NodeTree tree;  // ((a (b c)) d), with an unused place between
  tree.references = {7, 5, 6, 0, 1, 2};
  tree.nodes = {{{}, 5, 0}, {cube(1), 2, 1}, {cube(2), 1, 1}, {cube(9), 0, 1}, {},
                {{}, 7, 0}, {cube(3), 3, 3}, {cube(0), 0, 1}, {{}, 1, 0}};
  const FloatTree found = emit(tree, 8, "place");
  ASSERT_EQ(found.pairs.size(), 3U);
  EXPECT_EQ(found.primitive_ids,
            (std::vector<std::uint32_t>{7 | kLastOfLeaf, 6 | kLastOfLeaf, 5 | kLastOfLeaf, 0, 1, 2 | kLastOfLeaf}));
  EXPECT_TRUE(found.pairs[0].leaf[0] && found.pairs[0].leaf[1]);
  EXPECT_EQ(found.pairs[0].pointer[0], 1U);
  EXPECT_EQ(found.pairs[0].pointer[1], 2U);
  EXPECT_TRUE(found.pairs[1].leaf[0] && !found.pairs[1].leaf[1]);
  EXPECT_EQ(found.pairs[1].pointer[1], 0U);
  EXPECT_EQ(found.pairs[1].child[1].lower, glm::vec3(1)) << "the box around b and c";
  EXPECT_EQ(found.pairs[1].child[1].upper, glm::vec3(3));
  EXPECT_FALSE(found.pairs[2].leaf[0]);
  EXPECT_EQ(found.pairs[2].pointer[1], 3U);
  EXPECT_EQ(found.scene.upper, glm::vec3(4));
  EXPECT_EQ(found.largest_magnitude, 4);
  EXPECT_EQ(found.leaves, 4U);
  EXPECT_EQ(found.primitives, 8U);
  EXPECT_EQ(depth(found), 3);
}

TEST(NodeTree, of_one_leaf_has_no_pairs) {
  const FloatTree found = emit({{{cube(2), 0, 2}}, {1, 0}}, 2, "place");
  EXPECT_TRUE(found.pairs.empty());
  EXPECT_EQ(found.primitive_ids, (std::vector<std::uint32_t>{1, 0 | kLastOfLeaf}));
  EXPECT_EQ(found.scene.upper, glm::vec3(3));
  EXPECT_EQ(depth(found), 0);
}

TEST(NodeTree, may_be_as_deep_as_it_has_leaves) {
  constexpr std::uint32_t kLeaves = 300000;
  NodeTree tree;
  tree.nodes.resize(2 * kLeaves - 1);
  for (std::uint32_t i = 0; i + 1 < kLeaves; ++i) {
    tree.nodes[2 * i] = {{}, 2 * i + 1, 0};
    tree.nodes[2 * i + 1] = {cube(0), i, 1};
  }
  tree.nodes.back() = {cube(0), kLeaves - 1, 1};
  // A chain: node 2i has the leaf 2i + 1 and the node 2i + 2.
  for (std::uint32_t i = 0; i < kLeaves; ++i) tree.references.push_back(i);
  const FloatTree found = emit(tree, kLeaves, "place");
  EXPECT_EQ(found.leaves, kLeaves);
  EXPECT_EQ(depth(found), static_cast<int>(kLeaves) - 1);
}

std::string refusal_of(const std::string& text) {
  try {
    const Builder builder("--builder", text);
    return "taken: " + builder.text();
  } catch (const InputError& error) {
    return error.what();
  }
}

TEST(Builder, is_chosen_by_name_and_options) {
  EXPECT_EQ(refusal_of("lbvh"), "taken: lbvh");
  EXPECT_EQ(refusal_of("lbvh,leaf=4"), "--builder: option: found 'leaf', but lbvh has none");
  EXPECT_TRUE(refusal_of("octree").starts_with("--builder: found 'octree', wanted one of lbvh"))
      << refusal_of("octree");
}

TEST(Builder, options_that_are_words_are_read_by_index) {
  const std::vector<Option> options{word_option("top", "who splits the top", {"binning", "grid"}),
                                    {"bins", "of an axis", 16, 4, 32}};
  EXPECT_EQ(read_options("p", "x", options).word("top"), 0U);
  EXPECT_EQ(read_options("p", "x,bins=5,top=grid", options).word("top"), 1U);
  EXPECT_EQ(read_options("p", "x,bins=5,top=grid", options).integer("bins"), 5U);
  try {
    read_options("p", "x,top=tree", options);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "p: option top: found 'tree', wanted one of binning, grid");
  }
}

}  // namespace
}  // namespace cbvh::golden
