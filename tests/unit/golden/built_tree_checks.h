// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/common.hpp>
#include <glm/vector_relational.hpp>
#include <string>
#include <vector>

#include "golden/build/builder.h"
#include "golden/build/node_tree.h"
#include "golden/quantize/scale.h"
#include "golden/tree/digest.h"
#include "golden/tree/validate.h"
#include "golden/update/streaming.h"
#include "golden/update/top_down.h"

namespace cbvh::golden {

inline FloatTree build(const std::string& description, const Mesh& mesh) {
  return Builder("test", description).build(mesh);
}

/// Every triangle in exactly one leaf, no leaf larger than `leaf`, every box the smallest around what is below it,
/// pairs in emission order, at most `depth` levels.
inline void expect_tight_tree_of_all_triangles(const FloatTree& tree, const Mesh& mesh, std::uint64_t leaf,
                                               int depth_limit) {
  const std::vector<Box> boxes = triangle_boxes(mesh);
  ASSERT_EQ(tree.leaves, tree.pairs.size() + 1) << mesh.name;
  ASSERT_EQ(tree.primitives, boxes.size()) << mesh.name;
  ASSERT_LE(depth(tree), depth_limit) << mesh.name;
  std::vector<int> seen(boxes.size());
  std::uint32_t next_id = 0;
  const auto leaf_box = [&](std::uint32_t first) {
    EXPECT_EQ(first, next_id) << mesh.name << ": leaves in emission order";
    Box box{glm::vec3(INFINITY), glm::vec3(-INFINITY)};
    std::uint64_t size = 0;
    for (bool last = false; !last; ++next_id, ++size) {
      const std::uint32_t entry = tree.primitive_ids.at(next_id);
      const std::uint32_t id = entry & ~kLastOfLeaf;
      last = (entry & kLastOfLeaf) != 0;
      ++seen.at(id);
      box = {glm::min(box.lower, boxes[id].lower), glm::max(box.upper, boxes[id].upper)};
    }
    EXPECT_LE(size, leaf) << mesh.name;
    return box;
  };
  const auto same = [](const Box& a, const Box& b) { return a.lower == b.lower && a.upper == b.upper; };
  if (tree.pairs.empty()) {
    EXPECT_TRUE(same(tree.scene, leaf_box(0))) << mesh.name;
  }
  // Post-order: a pair's inner children lie right before it, child 1 last.
  for (std::uint32_t index = 0; index < tree.pairs.size(); ++index) {
    const FloatPair& pair = tree.pairs[index];
    if (!pair.leaf[1]) {
      ASSERT_EQ(pair.pointer[1], index - 1) << mesh.name;
    }
    for (int c = 0; c < 2; ++c) {
      if (pair.leaf[c]) continue;
      ASSERT_LT(pair.pointer[c], index) << mesh.name;
      const FloatPair& child = tree.pairs[pair.pointer[c]];
      const Box own{glm::min(child.child[0].lower, child.child[1].lower),
                    glm::max(child.child[0].upper, child.child[1].upper)};
      ASSERT_TRUE(same(pair.child[c], own)) << mesh.name << " pair " << index;
    }
  }
  // Leaves from left to right, by a walk from the root.
  struct Visit {
    std::uint32_t pair;
    int child;
  };
  std::vector<Visit> open;
  if (!tree.pairs.empty()) open.push_back({static_cast<std::uint32_t>(tree.pairs.size() - 1), 0});
  while (!open.empty()) {
    const Visit visit = open.back();
    open.pop_back();
    if (visit.child == 2) continue;
    open.push_back({visit.pair, visit.child + 1});
    const FloatPair& pair = tree.pairs[visit.pair];
    if (pair.leaf[visit.child]) {
      ASSERT_TRUE(same(pair.child[visit.child], leaf_box(pair.pointer[visit.child])))
          << mesh.name << " pair " << visit.pair;
    } else {
      open.push_back({pair.pointer[visit.child], 0});
    }
  }
  ASSERT_EQ(next_id, tree.primitive_ids.size()) << mesh.name;
  ASSERT_TRUE(std::all_of(seen.begin(), seen.end(), [](int times) { return times == 1; })) << mesh.name;
}

/// Streamed = top-down bit for bit, and both valid, for both codes and treelets of 1 and 3 levels.
inline void expect_streams_as_top_down(const FloatTree& tree, const std::string& name) {
  GridRules rules;
  rules.min_scale = exactness_limit(tree.largest_magnitude);
  for (const Code code : {Code::modulo, Code::relative}) {
    const CompressedTree top_down = compress_top_down(tree, rules, code);
    for (const Violation& violation : validate(top_down, tree)) ADD_FAILURE() << name << ": " << to_string(violation);
    for (const int levels : {1, 3}) {
      const CompressedTree streamed = compress_streaming(tree, rules, code, levels).tree;
      ASSERT_EQ(streamed.pairs, top_down.pairs) << name;
      ASSERT_EQ(digest(streamed), digest(top_down)) << name;
    }
  }
}

/// The same pairs, boxes, leaves and primitives in the same order.
inline void expect_same_tree(const FloatTree& found, const FloatTree& wanted, const std::string& name) {
  ASSERT_EQ(found.primitive_ids, wanted.primitive_ids) << name;
  ASSERT_EQ(found.pairs.size(), wanted.pairs.size()) << name;
  ASSERT_EQ(found.leaves, wanted.leaves) << name;
  for (std::size_t i = 0; i < found.pairs.size(); ++i) {
    for (int c = 0; c < 2; ++c) {
      ASSERT_EQ(found.pairs[i].child[c].lower, wanted.pairs[i].child[c].lower) << name << " pair " << i;
      ASSERT_EQ(found.pairs[i].child[c].upper, wanted.pairs[i].child[c].upper) << name << " pair " << i;
      ASSERT_EQ(found.pairs[i].leaf[c], wanted.pairs[i].leaf[c]) << name << " pair " << i;
      ASSERT_EQ(found.pairs[i].pointer[c], wanted.pairs[i].pointer[c]) << name << " pair " << i;
    }
  }
}

}  // namespace cbvh::golden
