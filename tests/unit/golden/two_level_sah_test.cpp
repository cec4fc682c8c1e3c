// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/build/two_level/two_level_sah.h"

#include <gtest/gtest.h>

#include <cmath>

#include "golden/scene/two_level/two_level_scenes.h"
#include "golden/tree/sah.h"
#include "tests/unit/golden/two_level_helpers.h"

namespace cbvh::golden {
namespace {

TEST(TwoLevelSah, of_one_instance_is_that_of_its_tree_and_scaling_changes_nothing) {
  for (const char* spec :
       {"deal,objects=1:proc:spheres,triangles=800,spheres=5", "deal,objects=1:proc:soup,triangles=90"}) {
    BuiltScene scene(load_two_level_scene(spec));
    const SahCosts costs{1.5, 2.5};
    const double wanted = sah(scene.floats[0], costs);
    const auto found = [&](const InstancedTrees& trees, const char* builder) {
      return two_level_sah(TopLevelBuilder("test", builder).build(trees), trees, world_of(trees), costs);
    };
    EXPECT_NEAR(found(scene.trees(), "plain"), wanted, wanted * 1e-12);
    EXPECT_NEAR(found(scene.compressed_trees(), "plain"), sah(scene.compressed[0], costs), wanted * 1e-12);
    glm::mat4 turned(0.0F);  // a quarter turn, mirrored, twice the size
    turned[0] = {0, 2, 0, 0};
    turned[1] = {0, 0, -2, 0};
    turned[2] = {2, 0, 0, 0};
    turned[3] = {1, 2, 3, 1};
    scene.scene.instances[0].to_world = turned;
    EXPECT_NEAR(found(scene.trees(), "agglomerative"), wanted, wanted * 1e-5) << "but for rounding outwards";
  }
}

/// Half the surface of what an instance makes of a box: the edges' vector products.
double image_area(const Box& box, const glm::mat4& m) {
  double edge[3][3];
  for (glm::length_t e = 0; e < 3; ++e) {
    const double extent = static_cast<double>(box.upper[e]) - static_cast<double>(box.lower[e]);
    for (glm::length_t row = 0; row < 3; ++row) edge[e][row] = static_cast<double>(m[e][row]) * extent;
  }
  double area = 0;
  for (int e = 0; e < 3; ++e) {
    const double* a = edge[e];
    const double* b = edge[(e + 1) % 3];
    area += std::hypot(a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]);
  }
  return area;
}

TEST(TwoLevelSah, of_both_levels_is_the_sum_over_every_node_of_every_instance) {
  const SahCosts costs{1.5, 2.5};
  int checks = 0;
  for (const char* spec : kTwoLevelScenes) {
    const BuiltScene scene(load_two_level_scene(spec));
    const InstancedTrees trees = scene.trees();
    const Box world = world_of(trees);
    for (const char* builder : {"plain", "agglomerative", "rebraid,open=leaves,space=10,triangles=2"}) {
      const TopLevel top = scene.build(builder);
      double sum = 0;
      const auto subtree = [&](const auto& self, const FloatTree& tree, const glm::mat4& m, bool leaf,
                               std::uint32_t pointer, double area) -> void {
        if (leaf) {
          sum += costs.intersection * leaf_size(tree.primitive_ids, pointer) * area;
          return;
        }
        sum += costs.traversal * area;
        const FloatPair& pair = tree.pairs[pointer];
        for (int c = 0; c < 2; ++c) self(self, tree, m, pair.leaf[c], pair.pointer[c], image_area(pair.child[c], m));
      };
      const auto node = [&](const auto& self, bool leaf, std::uint32_t pointer, const Box& box) -> void {
        if (!leaf) {
          sum += costs.traversal * half_area(box);
          const FloatPair& pair = top.tree.pairs[pointer];
          for (int c = 0; c < 2; ++c) self(self, pair.leaf[c], pair.pointer[c], pair.child[c]);
          return;
        }
        const SubtreeReference& to = top.references[top.tree.primitive_ids[pointer] & ~kLastOfLeaf];
        const Instance& instance = scene.scene.instances[to.instance];
        if (to.node.kind == ObjectNode::Kind::primitive) {
          sum += costs.intersection * half_area(box);
        } else {
          subtree(subtree, scene.floats[instance.object], instance.to_world, to.node.kind == ObjectNode::Kind::leaf,
                  to.node.index, half_area(box));
        }
      };
      const bool single = top.tree.pairs.empty();
      node(node, single, single ? 0 : static_cast<std::uint32_t>(top.tree.pairs.size() - 1), top.tree.scene);
      const double wanted = sum / half_area(world);
      EXPECT_NEAR(two_level_sah(top, trees, world, costs), wanted, wanted * 1e-9) << spec << ' ' << builder;
      ++checks;
    }
  }
  EXPECT_EQ(checks, 18);
}

}  // namespace
}  // namespace cbvh::golden
