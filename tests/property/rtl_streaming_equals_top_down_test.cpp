// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "golden/build/lbvh.h"
#include "golden/quantize/quantize.h"
#include "golden/scene/trouble_scenes.h"
#include "golden/tree/validate.h"
#include "golden/update/streaming.h"
#include "golden/update/top_down.h"
#include "rtl_model/compress/lazy_treelet_collector.h"
#include "tests/support/stream_run.h"

namespace cbvh::rtl {
namespace {

struct Tally {
  int scenes = 0;
  std::uint64_t pairs = 0;
};

/// Streams every kind of trouble through the RTL stream compressor, with one of the collectors, both codes and both
/// scale rules in turn.
template <int N>
Tally expect_streams_equal_top_down(std::uint64_t seeds) {
  Tally tally;
  for (const auto trouble : golden::kTroubles) {
    for (std::uint64_t seed = 0; seed < seeds; ++seed) {
      const auto mesh = golden::trouble_scene(trouble, seed * 16 + N);
      SCOPED_TRACE(mesh.name + " N=" + std::to_string(N));
      const auto tree = golden::build_lbvh(mesh);
      const auto rule = seed % 2 == 0 ? golden::ScaleRule::equation2 : golden::ScaleRule::figure5;
      const auto code = seed / 2 % 2 == 0 ? golden::Code::modulo : golden::Code::relative;
      const golden::GridRules rules{N, golden::exactness_limit(tree.largest_magnitude), rule};
      const auto top_down = golden::compress_top_down(tree, rules, code);
      ++tally.scenes;
      tally.pairs += tree.pairs.size();
      EXPECT_TRUE(golden::validate(top_down, tree).empty());
      if (tree.pairs.empty()) continue;
      const int levels = 1 + static_cast<int>(seed % 5);
      const auto registers = vectors::scene_registers(rules, code);
      const auto run = seed % 3 == 0 ? testing::run_stream<N, LazyTreeletCollector>(tree, registers, levels)
                                     : testing::run_stream<N, TreeletCollector>(tree, registers, levels);
      EXPECT_TRUE(run.finished);
      EXPECT_EQ(run.report.status.value(), 0u);
      EXPECT_TRUE(run.pairs == top_down.pairs);
      EXPECT_EQ(run.report.repairs.value(), golden::compress_streaming(tree, rules, code, levels).counts.backtracks);
    }
  }
  return tally;
}

TEST(RtlStreamingEqualsTopDown, on_over_a_thousand_small_troublesome_scenes_of_every_width) {
  Tally total;
  const auto add = [&](Tally tally) {
    total.scenes += tally.scenes;
    total.pairs += tally.pairs;
  };
  add(expect_streams_equal_top_down<2>(13));
  add(expect_streams_equal_top_down<3>(13));
  add(expect_streams_equal_top_down<4>(13));
  add(expect_streams_equal_top_down<5>(13));
  add(expect_streams_equal_top_down<6>(13));
  add(expect_streams_equal_top_down<7>(13));
  add(expect_streams_equal_top_down<8>(13));
  EXPECT_GE(total.scenes, 1000);
  EXPECT_GT(total.pairs, 10000u);
}

}  // namespace
}  // namespace cbvh::rtl
