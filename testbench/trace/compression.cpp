// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/trace/compression.h"

#include <algorithm>

#include "golden/quantize/scale.h"
#include "golden/scene/twist.h"
#include "golden/update/refit.h"
#include "golden/update/top_down.h"
#include "testbench/rtl/stream_tree.h"
#include "testbench/sim/simulate.h"

namespace cbvh::testbench {

namespace {

constexpr int kTreeletLevels = 4;
constexpr float kTurns = 0.1F;

bool same_tree(const golden::CompressedTree& a, const golden::CompressedTree& b) {
  return a.pairs == b.pairs && a.root == b.root && a.primitive_ids == b.primitive_ids;
}

golden::GridRules rules_of(const TraceTrees& trees, float largest) {
  return {.bits = trees.bits, .min_scale = golden::exactness_limit(largest)};
}

TreePair refit_pair(const golden::Mesh& mesh, const TraceTrees& trees) {
  const golden::FloatTree before = golden::Builder("--builder", trees.builder).build(golden::twisted(mesh, kTurns));
  golden::FloatTree floats = golden::refit(before, mesh);
  const golden::GridRules rules = rules_of(trees, std::max(before.largest_magnitude, floats.largest_magnitude));
  SimRequest request;
  request.config.bits = static_cast<unsigned>(rules.bits);
  request.config.code = trees.code;
  request.config.min_scale = rules.min_scale;
  request.config.memory = MemoryKind::ideal;
  check_sim_config(request.config);
  SimResult result = simulate_refit(golden::compress_top_down(before, rules, trees.code), mesh, request);
  const bool identical = same_tree(*result.tree, golden::compress_top_down(floats, rules, trees.code));
  return {std::move(floats), std::move(*result.tree), identical};
}

}  // namespace

TreePair compress(golden::FloatTree floats, const TraceTrees& trees) {
  const golden::GridRules rules = rules_of(trees, floats.largest_magnitude);
  golden::CompressedTree top_down = golden::compress_top_down(floats, rules, trees.code);
  if (trees.compression == Compression::top_down) return {std::move(floats), std::move(top_down), true};
  golden::CompressedTree streamed =
      stream_tree(floats, {rules, trees.code, kTreeletLevels, Collector::full, RunOptions()}).tree;
  const bool identical = same_tree(streamed, top_down);
  return {std::move(floats), std::move(streamed), identical};
}

TreePair build_and_compress(const golden::Mesh& mesh, const TraceTrees& trees) {
  if (trees.compression == Compression::refitted) return refit_pair(mesh, trees);
  return compress(golden::Builder("--builder", trees.builder).build(mesh), trees);
}

}  // namespace cbvh::testbench
