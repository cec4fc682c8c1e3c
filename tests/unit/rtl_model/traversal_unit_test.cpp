// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "rtl_model/traverse/traversal_unit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>
#include <vector>

#include "golden/update/top_down.h"
#include "rtl_model/kernel/clock.h"
#include "rtl_model/memory/ideal_line_memory.h"
#include "rtl_model/memory/line_link.h"
#include "testbench/rtl/leaf_answerer.h"
#include "testbench/rtl/ports.h"
#include "vectors/generate/ray_episode_steps.h"

namespace cbvh::rtl {
namespace {

using vectors::Random;
using Step = vectors::TraversalStep<6>;

struct Told {
  std::vector<RayCandidate> met;  ///< without slots
  std::vector<RayReport> reports;
  bool operator==(const Told&) const = default;
};

struct Outcome {
  std::map<std::uint64_t, Told> rays;  ///< by number
  std::uint64_t cycles = 0;
};

/// Nothing is hit: leaves answer with an infinite distance.
Outcome run(const std::vector<Step>& steps, std::size_t slots, unsigned memory_latency) {
  Channel<RayJob> jobs;
  Channel<RayCandidate> candidates;
  Channel<LeafReply> replies;
  Channel<RayReport> reports;
  LineLink pairs;
  LineLink ids;
  IdealLineMemory memory({pairs.port(), ids.port()}, 1 << 14, memory_latency);
  RayTree<6> tree;
  std::vector<RayJob> rays;
  for (const Step& step : steps) {
    const auto kind = static_cast<Step::Kind>(step.kind.value());
    if (kind == Step::Kind::tree) tree = step.tree;
    if (kind == Step::Kind::ray) rays.push_back(step.ray);
    for (std::size_t i = 0; kind == Step::Kind::memory && i < kWordsPerLine; ++i) {
      memory.store.poke(step.line.value() * kWordsPerLine + i, static_cast<std::uint32_t>(step.words[i].value()));
    }
  }
  TraversalUnit<MachineBits, 6> unit({jobs, candidates, replies, reports, pairs.port(), ids.port()}, tree, slots);
  testbench::Source<RayJob> source(jobs, rays, StallPattern::never());
  testbench::LeafAnswerer answerer(
      candidates, replies,
      [](const RayCandidate& candidate) {
        return LeafReply{candidate.slot, Float32::of(std::numeric_limits<float>::infinity()), {}};
      },
      testbench::SinkStalls::never());
  testbench::Sink<RayReport> sink(reports, testbench::SinkStalls::never());
  Clock clock(source, jobs, unit, pairs, ids, memory, candidates, answerer, replies, reports, sink);
  while (sink.items.size() < rays.size() && clock.cycle() < 1'000'000) clock.step();
  Outcome result;
  result.cycles = clock.cycle();
  for (RayCandidate candidate : answerer.met) {
    candidate.slot = {};
    result.rays[candidate.number.value()].met.push_back(candidate);
  }
  for (const RayReport& report : sink.items) result.rays[report.number.value()].reports.push_back(report);
  return result;
}

TEST(TraversalUnit, how_many_rays_are_on_their_way_changes_nothing_of_what_is_said_of_each) {
  Random random(1);
  std::size_t rays = 0;
  for (std::size_t i = 0; i < 64; ++i) {
    const auto steps =
        vectors::ray_steps<6>(vectors::make_ray_episode(i % vectors::kRayEpisodeClasses.size(), random, 6));
    const Outcome alone = run(steps, 1, 4);
    for (const auto& [number, told] : alone.rays) ASSERT_EQ(told.reports.size(), 1U);
    for (const std::size_t slots : {std::size_t{2}, std::size_t{7}, std::size_t{64}}) {
      const Outcome together = run(steps, slots, 4);
      ASSERT_EQ(together.rays, alone.rays) << slots;
      ASSERT_LE(together.cycles, alone.cycles);
    }
    rays += alone.rays.size();
  }
  EXPECT_GT(rays, 250U);
}

/// One ray along x down a left spine; every level leaves a leaf to the right, which the ray hits or not.
std::vector<Step> spine(std::uint32_t levels, bool hits_leaves) {
  golden::FloatTree tree;
  const golden::Box box{glm::vec3(0), glm::vec3(1)};
  const golden::Box leaf{glm::vec3(0, hits_leaves ? 0 : 0.875F, 0), glm::vec3(1)};
  for (std::uint32_t i = 0; i < levels; ++i) {
    tree.pairs.push_back({{box, leaf}, {i == 0, true}, {i == 0 ? levels : i - 1, i}});
  }
  for (std::uint32_t i = 0; i <= levels; ++i) tree.primitive_ids.push_back(i | golden::kLastOfLeaf);
  tree.leaves = levels + 1;
  tree.primitives = levels + 1;
  tree.scene = box;
  tree.largest_magnitude = 1;
  vectors::RayEpisode episode;
  episode.tree = golden::compress_top_down(tree, {6, -23, golden::ScaleRule::equation2}, golden::Code::modulo);
  RayJob ray;
  ray.origin = {Float32::of(-1), Float32::of(0.5F), Float32::of(0.5F)};
  ray.direction = {Float32::of(1), Float32::of(0), Float32::of(0)};
  ray.t_max = Float32::of(std::numeric_limits<float>::infinity());
  episode.rays = {ray};
  return vectors::ray_steps<6>(episode);
}

TEST(TraversalUnit, memory_is_waited_for_once_a_line_of_pairs_and_once_a_leaf) {
  constexpr std::uint32_t kLevels = 24;
  const auto steps = spine(kLevels, true);
  const Outcome near = run(steps, 1, 4);
  const Outcome far = run(steps, 1, 104);
  const RayReport& report = near.rays.at(0).reports.at(0);
  EXPECT_EQ(report.status.value(), 0U);
  EXPECT_EQ(report.pairs.value(), kLevels);
  EXPECT_EQ(report.leaves.value(), kLevels + 1);
  EXPECT_EQ(report.lines.value(), kLevels / kPairsPerLine) << "four pairs of the spine share a line";
  EXPECT_EQ(far.cycles - near.cycles, 100 * (report.lines.value() + report.leaves.value()));
}

TEST(TraversalUnit, a_step_within_a_line_takes_11_clocks_and_one_to_another_line_1_more_and_the_memorys_latency) {
  for (const unsigned latency : {4U, 50U}) {
    const Outcome longer = run(spine(24, false), 1, latency);
    const Outcome shorter = run(spine(12, false), 1, latency);
    EXPECT_EQ(longer.rays.at(0).reports.at(0).leaves.value(), 1U);
    EXPECT_EQ(longer.cycles - shorter.cycles, 12 * 11 + 3 * (1 + latency));
  }
}

}  // namespace
}  // namespace cbvh::rtl
