// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <utility>

#include "golden/build/float_tree.h"
#include "vectors/faces/line_memory.h"
#include "vectors/generate/ray_episode_steps.h"
#include "vectors/unit.h"

namespace cbvh::vectors {

/// Rays through a compressed tree in memory. An episode fills memory, says which primitives a ray hits, and gives rays;
/// the events are each ray's candidates and its report, ray after ray. The tree must be valid.
template <int N>
struct TraversalUnit {
  using Stimulus = TraversalStep<N>;
  using Response = TraversalEvent;
  static constexpr std::string_view kName = "traversal_unit";
  static constexpr std::string_view kSummary = "rays through a compressed tree in memory (here up to 4 at once)";
  static constexpr std::string_view kLatencyText = "11 a step, 12 + memory's to another line";
  static constexpr bool kStateful = true;
  static constexpr bool kTreelet = false;
  static constexpr const auto& kClasses = kRayEpisodeClasses;

  static std::vector<Stimulus> generate(std::size_t case_class, Random& random, const Parameters&) {
    return ray_steps<N>(make_ray_episode(case_class, random, N));
  }

  static std::vector<Expected<Response>> respond(std::span<const Stimulus> steps, const Parameters&) {
    std::vector<MemoryStep<rtl::RayJob>> lines;
    rtl::RayTree<N> tree;
    std::map<std::pair<std::uint64_t, std::uint64_t>, RayHit> hits;
    for (const Stimulus& step : steps) {
      const auto kind = static_cast<typename Stimulus::Kind>(step.kind.raw());
      if (kind == Stimulus::Kind::memory) lines.push_back({{}, step.line, step.words, {}});
      if (kind == Stimulus::Kind::tree) tree = step.tree;
      if (kind == Stimulus::Kind::hit) hits[{step.hit.number.raw(), step.hit.primitive.raw()}] = step.hit;
    }
    const LineMemory memory{std::span<const MemoryStep<rtl::RayJob>>(lines)};
    const PlainRayTree plain = plain_tree(tree, memory);
    std::vector<Expected<Response>> events;
    for (const Stimulus& step : steps) {
      if (static_cast<typename Stimulus::Kind>(step.kind.raw()) != Stimulus::Kind::ray) continue;
      PlainReply reply;
      std::uint32_t met = 0;
      const auto meet = [&](const PlainCandidate& candidate) {
        if (++met > kMostVisits) throw golden::InputError("ids", "found a ray without end, want leaves that end");
        const auto hit = hits.find({step.ray.number.raw(), candidate.primitive});
        if (hit != hits.end()) {
          reply.t = std::min(reply.t, hit->second.t.value());
          reply.stop = reply.stop || bool(hit->second.stop);
        }
        events.push_back({candidate_event(step.ray, candidate), kLatencyNotStated});
      };
      const auto answer = [&] { return std::exchange(reply, PlainReply()); };
      const TraversedRay ray = traverse(plain_ray(step.ray), plain, N, meet, answer);
      events.push_back({report_event(step.ray, ray), kLatencyNotStated});
    }
    return events;
  }

 private:
  /// Of an episode that has a tree in memory: cases that lost steps on the way to a minimal one may not.
  static constexpr std::uint32_t kMostVisits = 1 << 16;

  static PlainRayTree plain_tree(const rtl::RayTree<N>& tree, const LineMemory& memory) {
    PlainRayTree plain{[&memory, first = tree.pairs.raw(), opened = 0U](std::uint32_t index) mutable {
                         if (++opened > kMostVisits) throw golden::InputError("pairs", "found cycles, want a tree");
                         return memory.pair(first, index);
                       },
                       [&memory, first = tree.ids.raw()](std::uint32_t index) {
                         return memory.word(first * rtl::kWordsPerLine + index);
                       },
                       bool(tree.leaf),
                       static_cast<std::uint32_t>(tree.root.raw()),
                       {},
                       from_wires(rtl::ReachedNode<N>{tree.grid, {}}).grid,
                       tree.registers};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      plain.box[axis] = {tree.box.lower[axis].value(), tree.box.upper[axis].value()};
    }
    return plain;
  }

  static Response candidate_event(const rtl::RayJob& job, const PlainCandidate& candidate) {
    return {rtl::UInt<1>(0),
            {job.number,
             {},
             rtl::Pointer(candidate.entry_index),
             rtl::Pointer(candidate.primitive),
             rtl::UInt<1>(candidate.last_of_leaf),
             rtl::Float32::of(candidate.entry)},
            {}};
  }
  static Response report_event(const rtl::RayJob& job, const TraversedRay& ray) {
    using Count = rtl::UInt<rtl::kRayCountBits>;
    return {rtl::UInt<1>(1),
            {},
            {job.number, rtl::StatusBits(static_cast<std::uint64_t>(ray.status)), rtl::Pointer(ray.place),
             Count(ray.pairs), Count(ray.leaves), Count(ray.lines), rtl::Float32::of(ray.t_max)}};
  }
};

}  // namespace cbvh::vectors
