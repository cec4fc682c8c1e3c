// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/eval/two_level/forest.h"

#include <algorithm>
#include <chrono>

#include "golden/build/two_level/two_level_sah.h"
#include "golden/quantize/scale.h"
#include "golden/tree/decode.h"
#include "golden/update/top_down.h"

namespace cbvh::testbench {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

}  // namespace

golden::GridRules rules_of(const golden::FloatTree& tree) {
  return {.min_scale = golden::exactness_limit(tree.largest_magnitude)};
}

Forest::Forest(golden::TwoLevelScene from, const golden::Builder& builder)
    : Forest(std::move(from), builder, [](const golden::FloatTree& tree) {
        return golden::compress_top_down(tree, rules_of(tree), golden::Code::modulo);
      }) {}

Forest::Forest(golden::TwoLevelScene from, const golden::Builder& builder, const Compress& compress)
    : scene(std::move(from)) {
  const Clock::time_point start = Clock::now();
  for (const golden::Mesh& object : scene.objects) floats.push_back(builder.build(object));
  build_seconds = seconds_since(start);
  for (const golden::FloatTree& tree : floats) {
    compressed.push_back(compress(tree));
    pairs += tree.pairs.size();
  }
  float_trees.scene = compressed_trees.scene = &scene;
  for (const golden::FloatTree& tree : floats) float_trees.trees.push_back(golden::object_tree(tree));
  for (const golden::CompressedTree& tree : compressed)
    compressed_trees.trees.push_back(golden::object_tree(tree, scene.name));
  world = golden::world_of(float_trees);
}

double fastest_build(const golden::TopLevelBuilder& builder, const golden::InstancedTrees& trees, unsigned repeats,
                     golden::TopLevel& top) {
  double fastest = 0;
  for (unsigned i = 0; i < repeats; ++i) {
    const Clock::time_point start = Clock::now();
    top = builder.build(trees);
    const double seconds = seconds_since(start);
    fastest = i == 0 ? seconds : std::min(seconds, fastest);
  }
  return fastest;
}

golden::TopLevel decoded(const golden::TopLevel& top, const golden::CompressedTree& compressed) {
  golden::TopLevel result = top;
  const std::vector<std::array<golden::Box, 2>> boxes = golden::decode_boxes(compressed);
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    for (std::size_t c = 0; c < 2; ++c) result.tree.pairs[i].child[c] = boxes[i][c];
  }
  return result;
}

}  // namespace cbvh::testbench
