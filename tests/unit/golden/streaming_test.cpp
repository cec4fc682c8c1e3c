// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/update/streaming.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "golden/build/lbvh.h"
#include "golden/input_error.h"
#include "golden/scene/load.h"
#include "golden/scene/trouble_scenes.h"
#include "golden/tree/pair_codec.h"
#include "golden/update/top_down.h"
#include "golden/update/traffic.h"

namespace cbvh::golden {
namespace {

GridRules auto_rules(const FloatTree& tree) {
  return {6, exactness_limit(tree.largest_magnitude), ScaleRule::equation2};
}

/// Where each pair is: its parent (itself for the root) and its place in pre-order.
struct Places {
  explicit Places(const FloatTree& tree) : parent(tree.pairs.size()), rank(tree.pairs.size()) {
    const auto root = static_cast<std::uint32_t>(tree.pairs.size() - 1);
    parent[root] = root;
    visit(tree, root);
  }
  void visit(const FloatTree& tree, std::uint32_t pair) {
    rank[pair] = next++;
    for (int c = 0; c < 2; ++c) {
      if (tree.pairs[pair].leaf[c]) continue;
      parent[tree.pairs[pair].pointer[c]] = pair;
      visit(tree, tree.pairs[pair].pointer[c]);
    }
  }
  bool is_above(std::uint32_t ancestor, std::uint32_t pair) const {
    while (pair != ancestor && parent[pair] != pair) pair = parent[pair];
    return pair == ancestor;
  }
  std::vector<std::uint32_t> parent;
  std::vector<std::uint32_t> rank;
  std::uint32_t next = 0;
};

/// Replays the events into a memory of pairs and checks their order.
class Replay {
 public:
  Replay(const FloatTree& floats, const GridRules& grid_rules, Code tree_code, int levels)
      : tree(floats),
        rules(grid_rules),
        code(tree_code),
        places(floats),
        memory(floats.pairs.size()),
        written(floats.pairs.size()) {
    observer.on_final = [this](auto index, const auto& pair, const auto& context) { on_final(index, pair, context); };
    observer.on_repair = [this](auto index, const auto& old_pair, const auto& new_pair, const auto& from,
                                const auto& to) { on_repair(index, old_pair, new_pair, from, to); };
    result = compress_streaming(tree, rules, code, levels, &observer);
  }

  void on_final(std::uint32_t index, const CompressedPair& pair, const Context<std::int64_t>& context) {
    EXPECT_FALSE(written[index]);
    written[index] = true;
    memory[index] = pair;
    finals.push_back(index);
    last_repair = index;
    const PairCells<std::int64_t> cells = decode_codes(pair, context, code, rules.bits);
    EXPECT_EQ(cells, encode_cells(tree.pairs[index], context));
  }

  void on_repair(std::uint32_t index, const CompressedPair& old_pair, const CompressedPair& new_pair,
                 const Context<std::int64_t>& from, const Context<std::int64_t>& to) {
    EXPECT_TRUE(written[index]);
    EXPECT_EQ(memory[index], old_pair);
    EXPECT_NE(from, to);
    EXPECT_EQ(decode_codes(old_pair, from, code, rules.bits), encode_cells(tree.pairs[index], from));
    EXPECT_EQ(decode_codes(new_pair, to, code, rules.bits), encode_cells(tree.pairs[index], to));
    memory[index] = new_pair;
    EXPECT_TRUE(places.is_above(finals.back(), index)) << "repairs follow the pair that caused them";
    EXPECT_LT(places.rank[last_repair], places.rank[index]) << "child 0 and all below it before child 1";
    last_repair = index;
    ++repairs;
  }

  const FloatTree& tree;
  GridRules rules;
  Code code;
  Places places;
  StreamingObserver observer;
  StreamingResult result;
  std::vector<CompressedPair> memory;
  std::vector<bool> written;
  std::vector<std::uint32_t> finals;
  std::uint32_t last_repair = 0;
  std::uint64_t repairs = 0;
};

/// The order finals must come in, by the words of rule 10: for each arrival the pairs D - 1 levels below it, left to
/// right; then the rest.
std::vector<std::uint32_t> wanted_finals(const FloatTree& tree, int levels) {
  std::vector<std::uint32_t> order;
  const std::function<void(std::uint32_t, int)> below = [&](std::uint32_t pair, int distance) {
    if (distance == 0) return order.push_back(pair);
    for (int c = 0; c < 2; ++c) {
      if (!tree.pairs[pair].leaf[c]) below(tree.pairs[pair].pointer[c], distance - 1);
    }
  };
  const std::function<void(std::uint32_t, int)> rest = [&](std::uint32_t pair, int left) {
    if (left == 0) return;
    order.push_back(pair);
    for (int c = 0; c < 2; ++c) {
      if (!tree.pairs[pair].leaf[c]) rest(tree.pairs[pair].pointer[c], left - 1);
    }
  };
  for (std::uint32_t arrival = 0; arrival < tree.pairs.size(); ++arrival) below(arrival, levels - 1);
  rest(static_cast<std::uint32_t>(tree.pairs.size() - 1), levels - 1);
  return order;
}

TEST(Streaming, its_events_replay_to_the_tree_in_the_documented_order) {
  int checks = 0;
  std::uint64_t repairs = 0;
  for (std::uint64_t id = 0; id < 240; ++id) {
    const FloatTree tree = build_lbvh(trouble_scene(kTroubles[id % kTroubles.size()], id, 100));
    if (tree.pairs.empty()) continue;
    for (const Code code : {Code::modulo, Code::relative}) {
      for (int levels = 1; levels <= 4; ++levels) {
        const Replay replay(tree, auto_rules(tree), code, levels);
        ASSERT_TRUE(replay.memory == replay.result.tree.pairs);
        ASSERT_EQ(replay.repairs, replay.result.counts.backtracks);
        ASSERT_EQ(replay.finals, wanted_finals(tree, levels));
        repairs += replay.repairs;
        ++checks;
      }
    }
  }
  EXPECT_GT(checks, 1000);
  EXPECT_GT(repairs, 1000U);
}

TEST(Streaming, an_observer_changes_nothing) {
  const FloatTree tree = build_lbvh(load_scene("proc:cloth"));
  const Replay replay(tree, auto_rules(tree), Code::relative, 2);
  const StreamingResult plain = compress_streaming(tree, auto_rules(tree), Code::relative, 2);
  EXPECT_TRUE(replay.result.tree.pairs == plain.tree.pairs);
  EXPECT_EQ(replay.result.counts, plain.counts);
  EXPECT_GT(replay.repairs, 0U);
}

TEST(Streaming, arguments_out_of_their_domain_are_refused) {
  const FloatTree tree = build_lbvh(load_scene("proc:cloth"));
  const StreamingObserver observer;
  EXPECT_THROW(compress_streaming(tree, auto_rules(tree), Code::modulo, 0), InputError);
  EXPECT_THROW(compress_streaming(tree, auto_rules(tree), Code::modulo, 17), InputError);
  EXPECT_THROW(compress_streaming(tree, {.bits = 9}, Code::modulo, 1), InputError);
  EXPECT_THROW(compress_streaming(tree, {.min_scale = -60}, Code::modulo, 1, &observer), InputError);
}

TEST(Streaming, a_scene_that_is_one_leaf_has_no_pairs_and_no_backtracks) {
  const FloatTree tree = build_lbvh({"one", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}});
  const StreamingResult result = compress_streaming(tree, auto_rules(tree), Code::modulo, 4);
  EXPECT_TRUE(result.tree.pairs.empty());
  EXPECT_EQ(result.counts.backtracks, 0U);
  EXPECT_TRUE(compress_top_down(tree, auto_rules(tree), Code::modulo).pairs.empty());
}

TEST(Traffic, one_primitive_per_leaf_gives_figure_1) {
  const UpdateTraffic traffic = update_traffic(1'000'000, 1'000'000, 0);  // a pair a primitive
  EXPECT_EQ(traffic.lbvh.streaming_bytes, 124'000'000U);
  EXPECT_EQ(traffic.lbvh.baseline_bytes, 252'000'000U);
  EXPECT_EQ(traffic.refit.streaming_bytes, 76'000'000U);
  EXPECT_EQ(traffic.refit.baseline_bytes, 204'000'000U);
  EXPECT_NEAR(1 / traffic.lbvh.ratio(), 2.0, 0.05) << "up to ca. 2x more traffic";
  EXPECT_NEAR(1 / traffic.refit.ratio(), 2.6, 0.1) << "and 2.6x for refit";
  EXPECT_EQ(update_traffic(1, 1, 3).lbvh.streaming_bytes, 124U + 3 * 128);
  EXPECT_EQ(update_traffic(1, 1, 3).refit.streaming_bytes, 76U + 3 * 128);
  EXPECT_EQ(update_traffic(1, 1, 3).lbvh.baseline_bytes, 252U);
}

}  // namespace
}  // namespace cbvh::golden
