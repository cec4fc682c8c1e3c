// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// Small scenes of every kind of trouble through both compressors. CBVH_SCENE_COUNT sets how many (default 1344).
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <string>

#include "golden/build/lbvh.h"
#include "golden/quantize/scale.h"
#include "golden/scene/trouble_scenes.h"
#include "golden/tree/digest.h"
#include "golden/tree/validate.h"
#include "golden/update/streaming.h"
#include "golden/update/top_down.h"

namespace cbvh::golden {
namespace {

/// The rules of case `id`: every N, both scale rules; e_min mostly auto, else finer or coarser. With the twelve kinds
/// of scene these cross completely in 12 * 2 * 8 * 7 = 1344 cases.
GridRules rules_of(std::uint64_t id, const FloatTree& tree) {
  GridRules rules;
  rules.bits = 2 + static_cast<int>(id % 7);
  rules.scale_rule = id / 12 % 2 == 0 ? ScaleRule::equation2 : ScaleRule::figure5;
  rules.min_scale = exactness_limit(tree.largest_magnitude);
  switch (id / 24 % 8) {
    case 3:
      rules.min_scale = std::max(-149, rules.min_scale - 20);
      break;
    case 4:
      rules.min_scale = -149;
      break;
    case 5:
      rules.min_scale = -30;
      break;
    case 6:
      rules.min_scale = std::min(127, rules.min_scale + 17);
      break;
    default:
      break;
  }
  return rules;
}

std::uint64_t scene_count() {
  const char* text = std::getenv("CBVH_SCENE_COUNT");
  return text == nullptr ? 1344 : std::stoull(text);
}

/// Backtracks of a D-level run are those of the D = 1 run at depth >= D, depth by depth.
void expect_tail(const StreamingCounts& all, const StreamingCounts& counts, int levels) {
  std::uint64_t tail = 0;
  for (std::size_t depth = 0; depth < all.depth_histogram.size(); ++depth) {
    const std::uint64_t found = depth < counts.depth_histogram.size() ? counts.depth_histogram[depth] : 0;
    const std::uint64_t wanted = depth >= static_cast<std::size_t>(levels) ? all.depth_histogram[depth] : 0;
    ASSERT_EQ(found, wanted) << "depth " << depth;
    tail += wanted;
  }
  ASSERT_EQ(counts.backtracks, tail);
}

TEST(StreamingEqualsTopDown, for_every_kind_of_trouble_code_rule_width_and_treelet_depth) {
  std::uint64_t compared = 0;
  std::uint64_t pairs = 0;
  std::uint64_t backtracks = 0;
  const std::uint64_t scenes = scene_count();
  for (std::uint64_t id = 0; id < scenes; ++id) {
    const Mesh mesh = trouble_scene(kTroubles[id % kTroubles.size()], id);
    const FloatTree tree = build_lbvh(mesh);
    const GridRules rules = rules_of(id, tree);
    const std::uint64_t modulo_digest = digest(compress_top_down(tree, rules, Code::modulo));
    for (const Code code : {Code::modulo, Code::relative}) {
      SCOPED_TRACE(fmt::format("{} N={} e_min={} figure5={} relative={}", mesh.name, rules.bits, rules.min_scale,
                               rules.scale_rule == ScaleRule::figure5, code == Code::relative));
      const CompressedTree top_down = compress_top_down(tree, rules, code);
      const std::vector<Violation> violations = validate(top_down, tree);
      ASSERT_TRUE(violations.empty()) << to_string(violations.front());
      ASSERT_EQ(digest(top_down), modulo_digest);
      StreamingCounts all;
      for (const int levels : {1, 2, 3, 4, 8}) {
        const StreamingResult streamed = compress_streaming(tree, rules, code, levels);
        ASSERT_TRUE(streamed.tree.pairs == top_down.pairs) << "D = " << levels;
        if (levels == 1) all = streamed.counts;
        expect_tail(all, streamed.counts, levels);
        ++compared;
      }
      backtracks += all.backtracks;
    }
    pairs += tree.pairs.size();
  }
  EXPECT_EQ(compared, scenes * 10);
  EXPECT_GT(pairs, scenes * 5);
  EXPECT_GT(backtracks, scenes);
}

}  // namespace
}  // namespace cbvh::golden
