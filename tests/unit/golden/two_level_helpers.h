// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "golden/build/builder.h"
#include "golden/build/two_level/faults.h"
#include "golden/build/two_level/top_level.h"
#include "golden/quantize/scale.h"
#include "golden/tree/validate.h"
#include "golden/update/streaming.h"
#include "golden/update/top_down.h"

namespace cbvh::golden {

/// Instances of one object and objects in place, few and many, apart and overlapping.
inline constexpr const char* kTwoLevelScenes[] = {
    "bounce,count=1:proc:soup,triangles=50",
    "bounce,count=2,size=1:proc:soup,triangles=50",
    "bounce,count=40,size=0.5,time=2:proc:hairball,triangles=500,segments=10",
    "deal,objects=5:proc:spheres,triangles=800,spheres=5",
    "deal,objects=40,chunk=3:proc:terrain,triangles=2000",
    "deal,objects=3,chunk=1000:proc:cloth,sheet=20,height=20",
};

/// A scene with trees of its objects, float and compressed.
struct BuiltScene {
  explicit BuiltScene(TwoLevelScene from, Code code = Code::modulo, const std::string& builder = "lbvh")
      : scene(std::move(from)) {
    check_scene(scene);
    for (const Mesh& object : scene.objects) {
      floats.push_back(Builder("test", builder).build(object));
      const GridRules rules{.min_scale = exactness_limit(floats.back().largest_magnitude)};
      compressed.push_back(compress_top_down(floats.back(), rules, code));
    }
  }

  InstancedTrees trees() const {
    InstancedTrees result{&scene, {}};
    for (const FloatTree& tree : floats) result.trees.push_back(object_tree(tree));
    return result;
  }
  InstancedTrees compressed_trees() const {
    InstancedTrees result{&scene, {}};
    for (const CompressedTree& tree : compressed) result.trees.push_back(object_tree(tree, scene.name));
    return result;
  }
  TopLevel build(const std::string& description) const { return TopLevelBuilder("test", description).build(trees()); }

  TwoLevelScene scene;
  std::vector<FloatTree> floats;
  std::vector<CompressedTree> compressed;
};

inline void expect_same(const TopLevel& a, const TopLevel& b) {
  ASSERT_EQ(a.references.size(), b.references.size());
  for (std::size_t i = 0; i < a.references.size(); ++i) {
    ASSERT_EQ(a.references[i].instance, b.references[i].instance) << i;
    ASSERT_EQ(a.references[i].node.kind, b.references[i].node.kind) << i;
    ASSERT_EQ(a.references[i].node.index, b.references[i].node.index) << i;
    ASSERT_EQ(a.references[i].node.context, b.references[i].node.context) << i;
  }
  ASSERT_EQ(a.tree.primitive_ids, b.tree.primitive_ids);
  ASSERT_EQ(a.tree.pairs.size(), b.tree.pairs.size());
  for (std::size_t i = 0; i < a.tree.pairs.size(); ++i) {
    for (int c = 0; c < 2; ++c) {
      ASSERT_EQ(a.tree.pairs[i].leaf[c], b.tree.pairs[i].leaf[c]) << i;
      ASSERT_EQ(a.tree.pairs[i].pointer[c], b.tree.pairs[i].pointer[c]) << i;
      ASSERT_EQ(a.tree.pairs[i].child[c].lower, b.tree.pairs[i].child[c].lower) << i;
      ASSERT_EQ(a.tree.pairs[i].child[c].upper, b.tree.pairs[i].child[c].upper) << i;
    }
  }
}

/// The top level is a tree like any other: compressed it is valid and encloses its float boxes, and streamed it is the
/// same, for both codes and several treelet depths.
inline void expect_compresses(const TopLevel& top) {
  const GridRules rules{.min_scale = exactness_limit(top.tree.largest_magnitude)};
  for (const Code code : {Code::modulo, Code::relative}) {
    const CompressedTree compressed = compress_top_down(top.tree, rules, code);
    ASSERT_TRUE(validate(compressed, top.tree).empty());
    for (const int levels : {1, 2, 4}) {
      const CompressedTree streamed = compress_streaming(top.tree, rules, code, levels).tree;
      ASSERT_EQ(streamed.pairs, compressed.pairs);
      ASSERT_EQ(streamed.primitive_ids, compressed.primitive_ids);
    }
  }
}

}  // namespace cbvh::golden
