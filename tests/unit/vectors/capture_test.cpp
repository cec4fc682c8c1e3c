// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// Stimuli from real scenes.
#include <gtest/gtest.h>

#include "golden/build/lbvh.h"
#include "golden/scene/load.h"
#include "vectors/capture.h"
#include "vectors/format/format.h"
#include "vectors/registry.h"

namespace cbvh::vectors {
namespace {

const std::string kScene = "proc:terrain,triangles=600";

/// What a unit meets; nothing for a unit that is not part of compressing a tree.
std::unique_ptr<VectorSet> captured(const UnitDescription& unit, const CaptureOptions& options) {
  try {
    return capture_set(unit.name, {6, unit.treelets.size() > 1 ? 2 : 1}, kScene, options);
  } catch (const golden::InputError& error) {
    EXPECT_EQ(error.what(), fmt::format("unit: {} meets nothing in this scene", unit.name));
    return nullptr;
  }
}

TEST(Capture, every_unit_of_compression_meets_something_and_the_golden_agrees_after_a_round_trip) {
  std::size_t met = 0;
  for (const UnitDescription& unit : units()) {
    CaptureOptions options;
    options.cases = 40;
    const auto set = captured(unit, options);
    if (set == nullptr) continue;
    ++met;
    EXPECT_GT(set->size(), 1U) << unit.name;
    EXPECT_LE(set->size(), 40U) << unit.name;
    const auto read = parse_set(serialize(*set, Format::text), "file");
    EXPECT_TRUE(read->equals(*set));
    EXPECT_EQ(read->verify().mismatches, 0U) << unit.name;
    for (std::size_t i = 0; i < set->size(); ++i) EXPECT_EQ(set->class_name(i), kCaptured);
  }
  EXPECT_EQ(met, 12U);
}

TEST(Capture, without_a_limit_it_takes_everything) {
  const golden::FloatTree tree = golden::build_lbvh(golden::load_scene(kScene));
  CaptureOptions options;
  options.cases = ~std::uint64_t{0};
  EXPECT_EQ(capture_set("node_pair_compressor", {}, tree, options)->size(), tree.pairs.size());
  EXPECT_EQ(capture_set("axis_compressor", {}, tree, options)->size(), 6 * tree.pairs.size());
  EXPECT_EQ(capture_set("scale_estimator", {}, tree, options)->size(), 3 * tree.pairs.size());
  EXPECT_EQ(capture_set("box_decoder", {}, tree, options)->size(), 2 * tree.pairs.size());
  EXPECT_EQ(capture_set("pair_intersector", {}, tree, options)->size(), tree.pairs.size());
  options.treelet = 2;
  EXPECT_GT(capture_set("node_pair_compressor", {}, tree, options)->size(), tree.pairs.size())
      << "pairs below a treelet's root are compressed anew";
  options.episode_pairs = static_cast<std::uint32_t>(tree.pairs.size());
  EXPECT_EQ(capture_set("stream_compressor", {}, tree, options)->size(), 1U) << "the whole scene is one episode";
}

TEST(Capture, a_share_is_spread_evenly) {
  CaptureOptions options;
  options.cases = ~std::uint64_t{0};
  const auto all = capture_set("axis_compressor", {}, kScene, options);
  options.cases = 10;
  const auto some = capture_set("axis_compressor", {}, kScene, options);
  EXPECT_EQ(some->size(), 10U);
  EXPECT_LT(some->size(), all->size());
}

TEST(Capture, what_it_cannot_do_is_said) {
  const auto error_of = [](const std::string& scene, const CaptureOptions& options) -> std::string {
    try {
      capture_set("axis_compressor", {}, scene, options);
    } catch (const golden::InputError& error) {
      return error.what();
    }
    return "no error";
  };
  CaptureOptions options;
  EXPECT_EQ(error_of("proc:soup,triangles=1", options), "unit: axis_compressor meets nothing in this scene");
  options.min_scale = -140;
  EXPECT_TRUE(error_of(kScene, options).starts_with("min-scale: found -140, want at least -2"))
      << error_of(kScene, options);
}

}  // namespace
}  // namespace cbvh::vectors
