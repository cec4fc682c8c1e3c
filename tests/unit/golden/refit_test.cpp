// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/update/refit.h"

#include <gtest/gtest.h>

#include <functional>
#include <glm/common.hpp>

#include "golden/build/lbvh.h"
#include "golden/input_error.h"
#include "golden/quantize/scale.h"
#include "golden/scene/load.h"
#include "golden/scene/trouble_scenes.h"
#include "golden/tree/validate.h"
#include "golden/update/streaming.h"
#include "golden/update/top_down.h"

namespace cbvh::golden {
namespace {

/// The box of all vertices below a node, without any box in between.
Box vertices_below(const FloatTree& tree, const Mesh& mesh, bool leaf, std::uint32_t pointer) {
  Box box{glm::vec3(INFINITY), glm::vec3(-INFINITY)};
  const std::function<void(bool, std::uint32_t)> visit = [&](bool is_leaf, std::uint32_t at) {
    if (!is_leaf) {
      for (int c = 0; c < 2; ++c) visit(tree.pairs[at].leaf[c], tree.pairs[at].pointer[c]);
      return;
    }
    for (;; ++at) {
      const glm::uvec3 triangle = mesh.triangles[tree.primitive_ids[at] & ~kLastOfLeaf];
      for (int corner = 0; corner < 3; ++corner) {
        box.lower = glm::min(box.lower, mesh.positions[triangle[corner]]);
        box.upper = glm::max(box.upper, mesh.positions[triangle[corner]]);
      }
      if ((tree.primitive_ids[at] & kLastOfLeaf) != 0) return;
    }
  };
  visit(leaf, pointer);
  return box;
}

TEST(Refit, every_box_is_that_of_the_moved_vertices_below_it_and_compresses_to_one_tree_both_ways) {
  std::size_t checks = 0;
  for (std::uint64_t id = 0; id < 120; ++id) {
    Mesh mesh = trouble_scene(kTroubles[id % kTroubles.size()], id, 60);
    const FloatTree before = build_lbvh(mesh);
    for (glm::vec3& p : mesh.positions) p = glm::vec3(p.z, -p.x, p.y * 0.5F);
    const FloatTree tree = refit(before, mesh);
    for (const FloatPair& pair : tree.pairs) {
      for (int c = 0; c < 2; ++c) {
        const Box wanted = vertices_below(tree, mesh, pair.leaf[c], pair.pointer[c]);
        ASSERT_EQ(pair.child[c].lower, wanted.lower);
        ASSERT_EQ(pair.child[c].upper, wanted.upper);
        ++checks;
      }
    }
    const GridRules rules{6, exactness_limit(tree.largest_magnitude), ScaleRule::equation2};
    const CompressedTree top_down = compress_top_down(tree, rules, Code::modulo);
    ASSERT_TRUE(validate(top_down, tree).empty());
    ASSERT_TRUE(compress_streaming(tree, rules, Code::modulo, 2).tree.pairs == top_down.pairs);
  }
  EXPECT_GT(checks, 1000U);
}

TEST(Refit, of_unmoved_triangles_changes_nothing) {
  const Mesh mesh = load_scene("proc:cloth");
  const FloatTree before = build_lbvh(mesh);
  const FloatTree after = refit(before, mesh);
  ASSERT_EQ(after.pairs.size(), before.pairs.size());
  for (std::size_t i = 0; i < before.pairs.size(); ++i) {
    for (int c = 0; c < 2; ++c) {
      ASSERT_EQ(after.pairs[i].child[c].lower, before.pairs[i].child[c].lower);
      ASSERT_EQ(after.pairs[i].child[c].upper, before.pairs[i].child[c].upper);
    }
  }
  EXPECT_EQ(after.scene.lower, before.scene.lower);
  EXPECT_EQ(after.scene.upper, before.scene.upper);
}

TEST(Refit, a_mesh_of_another_size_is_refused) {
  Mesh mesh = load_scene("proc:cloth");
  const FloatTree tree = build_lbvh(mesh);
  mesh.triangles.pop_back();
  EXPECT_THROW(refit(tree, mesh), InputError);
}

}  // namespace
}  // namespace cbvh::golden
