// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "golden/build/builder.h"
#include "golden/build/check_tree.h"
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

/// What check_tree asks, every triangle once, no leaf larger than `leaf`, at most `depth_limit` levels.
inline void expect_tree_of_all_triangles(const FloatTree& tree, const Mesh& mesh, std::uint64_t leaf, int depth_limit) {
  for (const std::string& finding : check_tree(tree, mesh)) ADD_FAILURE() << mesh.name << ": " << finding;
  ASSERT_EQ(tree.primitives, mesh.triangles.size()) << mesh.name;
  ASSERT_EQ(tree.primitive_ids.size(), mesh.triangles.size()) << mesh.name;
  ASSERT_LE(depth(tree), depth_limit) << mesh.name;
  std::uint64_t size = 0;
  for (const std::uint32_t entry : tree.primitive_ids) {
    ASSERT_LE(++size, leaf) << mesh.name;
    if ((entry & kLastOfLeaf) != 0) size = 0;
  }
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
