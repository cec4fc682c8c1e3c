// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/build/sweep.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <bit>

#include "golden/build/radix_order.h"
#include "golden/scene/trouble_scenes.h"
#include "golden/tree/sah.h"
#include "tests/unit/golden/built_tree_checks.h"
#include "tests/unit/golden/naive_sah.h"

namespace cbvh::golden {
namespace {

TEST(Sweep, equals_the_naive_builder_on_every_kind_of_trouble) {
  std::size_t pairs = 0;
  for (std::uint64_t id = 0; id < 240; ++id) {
    const Mesh mesh = trouble_scene(kTroubles[id % kTroubles.size()], id, 60);
    NaiveSah naive;
    naive.leaf = 1 + id % 5;
    naive.depth = 6 + static_cast<int>(id % 3);
    naive.traversal = static_cast<double>(id % 4) * 0.5;
    naive.intersection = 1 + static_cast<double>(id % 3);
    naive.candidates = NaiveSah::positions;
    const std::string builder = fmt::format("sweep,leaf={},depth={},traversal={},intersection={}", naive.leaf,
                                            naive.depth, naive.traversal, naive.intersection);
    const FloatTree tree = build(builder, mesh);
    expect_same_tree(tree, naive.build(mesh), mesh.name + " " + builder);
    if (HasFatalFailure()) return;
    pairs += tree.pairs.size();
  }
  EXPECT_GT(pairs, 3'000U);
}

TEST(Sweep, trees_of_trouble_are_tight_within_their_depth_and_stream_as_top_down) {
  for (std::uint64_t id = 0; id < 96; ++id) {
    const Mesh mesh = trouble_scene(kTroubles[id % kTroubles.size()], id, 300);
    const FloatTree tree = build("sweep,depth=9,leaf=2", mesh);
    expect_tree_of_all_triangles(tree, mesh, 2, 9);
    expect_streams_as_top_down(tree, mesh.name);
    if (HasFatalFailure()) return;
  }
}

TEST(Sweep, is_the_same_tree_when_every_node_sorts_its_triangles) {
  for (std::uint64_t id = 0; id < 96; ++id) {
    const Mesh mesh = trouble_scene(kTroubles[id % kTroubles.size()], id, 300);
    expect_same_tree(build("sweep,leaf=2,sort=node", mesh), build("sweep,leaf=2", mesh), mesh.name);
    if (HasFatalFailure()) return;
  }
}

TEST(RadixOrder, is_the_stable_order_of_floats_of_all_signs_and_magnitudes) {
  std::vector<float> keys;
  std::uint64_t state = 1;
  for (int i = 0; i < 3000; ++i) {
    state = state * 6364136223846793005U + 1442695040888963407U;
    const auto bits = static_cast<std::uint32_t>(state >> 32);
    keys.push_back(std::isfinite(std::bit_cast<float>(bits)) ? std::bit_cast<float>(bits) : 0.0F);
    keys.push_back(i % 2 == 0 ? -0.0F : static_cast<float>(i % 7));
  }
  std::vector<std::uint32_t> wanted(keys.size());
  for (std::uint32_t i = 0; i < wanted.size(); ++i) wanted[i] = i;
  std::stable_sort(wanted.begin(), wanted.end(), [&](auto a, auto b) { return keys[a] < keys[b]; });
  EXPECT_EQ(radix_order(keys), wanted);
  EXPECT_TRUE(radix_order({}).empty());
}

}  // namespace
}  // namespace cbvh::golden
