// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/build/binned.h"

#include <gtest/gtest.h>

#include <fmt/format.h>

#include "golden/build/sah_bins.h"
#include "golden/input_error.h"
#include "golden/scene/trouble_scenes.h"
#include "tests/unit/golden/built_tree_checks.h"
#include "tests/unit/golden/naive_sah.h"

namespace cbvh::golden {
namespace {

/// Every border between two of `bins` bins of equal width between the centroids, axis after axis; every position if
/// there are no more triangles than bins.
std::vector<NaiveSah::Halves> borders(const NaiveSah& scene, const NaiveSah::Ids& ids, int bins) {
  if (ids.size() <= static_cast<std::size_t>(bins)) return NaiveSah::positions(scene, ids);
  std::vector<NaiveSah::Halves> candidates;
  for (int axis = 0; axis < 3; ++axis) {
    float lower = scene.centroid(ids[0], axis);
    float upper = lower;
    for (const std::uint32_t id : ids) {
      lower = std::min(lower, scene.centroid(id, axis));
      upper = std::max(upper, scene.centroid(id, axis));
    }
    const double extent = static_cast<double>(upper) - static_cast<double>(lower);
    if (extent == 0) continue;
    const auto scale = static_cast<float>(std::min<double>(bins / extent, std::numeric_limits<float>::max()));
    for (int border = 1; border < bins; ++border) {
      NaiveSah::Halves halves;
      for (const std::uint32_t id : ids) {
        const float place = (scene.centroid(id, axis) - lower) * scale;
        (std::min(place, static_cast<float>(bins - 1)) < static_cast<float>(border) ? halves.left : halves.right)
            .push_back(id);
      }
      if (!halves.left.empty() && !halves.right.empty()) candidates.push_back(halves);
    }
  }
  return candidates;
}

TEST(Binned, equals_the_naive_builder_on_every_kind_of_trouble) {
  std::size_t pairs = 0;
  for (std::uint64_t id = 0; id < 240; ++id) {
    const Mesh mesh = trouble_scene(kTroubles[id % kTroubles.size()], id, 60);
    const int bins = 4 + static_cast<int>(id % 29);
    NaiveSah naive;
    naive.leaf = 1 + id % 5;
    naive.depth = 6 + static_cast<int>(id % 3);
    naive.traversal = static_cast<double>(id % 4) * 0.5;
    naive.intersection = 1 + static_cast<double>(id % 3);
    naive.candidates = [bins](const NaiveSah& scene, const NaiveSah::Ids& ids) { return borders(scene, ids, bins); };
    const std::string builder = fmt::format("binned,bins={},leaf={},depth={},traversal={},intersection={}", bins,
                                            naive.leaf, naive.depth, naive.traversal, naive.intersection);
    const FloatTree tree = build(builder, mesh);
    expect_same_tree(tree, naive.build(mesh), mesh.name + " " + builder);
    if (HasFatalFailure()) return;
    pairs += tree.pairs.size();
  }
  EXPECT_GT(pairs, 3'000U);
}

TEST(Binned, trees_of_trouble_are_tight_within_their_depth_and_stream_as_top_down) {
  for (std::uint64_t id = 0; id < 96; ++id) {
    const Mesh mesh = trouble_scene(kTroubles[id % kTroubles.size()], id, 300);
    const FloatTree tree = build("binned,depth=9,leaf=2", mesh);
    expect_tree_of_all_triangles(tree, mesh, 2, 9);
    expect_streams_as_top_down(tree, mesh.name);
    if (HasFatalFailure()) return;
  }
}

TEST(Binned, the_split_of_bins_is_the_same_however_their_contents_are_shared_out_and_merged) {
  const Mesh mesh = trouble_scene(Trouble::mixed_scales, 7, 500);
  WideBox centroids;
  std::vector<WideBox> boxes;
  for (const Box& box : triangle_boxes(mesh)) boxes.push_back(widened(box));
  for (const WideBox& box : boxes) centroids.enclose(box.centroid());
  const BinMapping mapping(centroids, 16);
  SahBins all(16);
  SahBins first(16);
  SahBins second(16);
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const auto weight = static_cast<std::uint32_t>(1 + i % 3);
    all.add(mapping.bin_of(boxes[i].centroid()), boxes[i], weight);
    (i % 5 == 0 ? first : second).add(mapping.bin_of(boxes[i].centroid()), boxes[i], weight);
  }
  second.merge(first);
  ASSERT_TRUE(all.best().exists());
  EXPECT_EQ(second.best().cost, all.best().cost);
  EXPECT_EQ(second.best().axis, all.best().axis);
  EXPECT_EQ(second.best().position, all.best().position);
  EXPECT_EQ(second.best().left, all.best().left);
}

TEST(Binned, more_triangles_than_the_depth_holds_is_an_error_that_says_so) {
  const Mesh mesh{"nine", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, std::vector<glm::uvec3>(9, {0, 1, 2})};
  EXPECT_EQ(build("binned,depth=2,leaf=3", mesh).primitive_ids.size(), 9U);
  try {
    build("binned,depth=2,leaf=2", mesh);
    FAIL() << "nine triangles in four leaves of two";
  } catch (const InputError& error) {
    EXPECT_STREQ(
        error.what(),
        "nine: 9 triangles do not fit 2 levels of inner nodes with leaves of 2, want more depth or larger leaves");
  }
}

}  // namespace
}  // namespace cbvh::golden
