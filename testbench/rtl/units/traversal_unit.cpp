// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "rtl_model/traverse/traversal_unit.h"

#include <algorithm>
#include <map>

#include "testbench/rtl/counting_bits.h"
#include "testbench/rtl/in_out_bench.h"
#include "testbench/rtl/leaf_answerer.h"
#include "testbench/rtl/line_channels.h"
#include "testbench/rtl/line_memory.h"
#include "vectors/ray_steps.h"

namespace cbvh::testbench {

namespace {

using vectors::TraversalEvent;
using vectors::TraversalStep;

constexpr std::size_t kRaysAtOnce = 4;

using Hits = std::map<std::pair<std::uint64_t, std::uint64_t>, vectors::RayHit>;

/// The steps, sorted by kind, and memory as they leave it.
template <int N>
struct Scene {
  rtl::RayTree<N> tree;
  Hits hits;
  std::vector<rtl::RayJob> rays;

  Scene(std::span<const TraversalStep<N>> steps, rtl::LineStore& store) {
    using Kind = typename TraversalStep<N>::Kind;
    for (const TraversalStep<N>& step : steps) {
      switch (static_cast<Kind>(step.kind.value())) {
        case Kind::memory:
          for (std::size_t i = 0; i < rtl::kWordsPerLine; ++i) {
            store.poke(step.line.value() * rtl::kWordsPerLine + i, static_cast<std::uint32_t>(step.words[i].value()));
          }
          break;
        case Kind::tree:
          tree = step.tree;
          break;
        case Kind::hit:
          hits[{step.hit.number.value(), step.hit.primitive.value()}] = step.hit;
          break;
        case Kind::ray:
          rays.push_back(step.ray);
          break;
      }
    }
  }
};

rtl::LeafReply look_up(const Hits& hits, const rtl::RayCandidate& candidate) {
  const auto found = hits.find({candidate.number.value(), candidate.primitive.value()});
  if (found == hits.end()) return {candidate.slot, rtl::Float32{0x7F800000}, {}};
  return {candidate.slot, found->second.t, found->second.stop};
}

/// What is said of each ray, in the order of the rays; of rays that were never sent, at the end.
void add_events(const std::vector<rtl::RayJob>& rays, std::vector<rtl::RayCandidate> met,
                std::vector<rtl::RayReport> reports, Responses& responses) {
  const auto add = [&](const TraversalEvent& event) { responses.add(&event, vectors::kLatencyNotStated); };
  const auto take = [&](auto& items, auto&& of_ray, auto&& tell) {
    const auto rest = std::stable_partition(items.begin(), items.end(), of_ray);
    std::for_each(items.begin(), rest, tell);
    items.erase(items.begin(), rest);
  };
  const auto tell_candidate = [&](rtl::RayCandidate candidate) {
    candidate.slot = {};
    add({rtl::UInt<1>(0), candidate, {}});
  };
  const auto tell_report = [&](const rtl::RayReport& report) { add({rtl::UInt<1>(1), {}, report}); };
  for (const rtl::RayJob& ray : rays) {
    const auto of_ray = [&](const auto& item) { return item.number == ray.number; };
    take(met, of_ray, tell_candidate);
    take(reports, of_ray, tell_report);
  }
  std::for_each(met.begin(), met.end(), tell_candidate);
  std::for_each(reports.begin(), reports.end(), tell_report);
}

/// Gives up when more candidates came than there should be responses: a unit that has lost its way may never stop.
template <int N>
bool run_steps(std::span<const TraversalStep<N>> steps, std::size_t wanted, const RunOptions& options,
               std::uint64_t number, Responses& responses) {
  rtl::Channel<rtl::RayJob> ray_channel;
  rtl::Channel<rtl::RayCandidate> candidates;
  rtl::Channel<rtl::LeafReply> replies;
  rtl::Channel<rtl::RayReport> reports;
  LineChannels pairs, ids;
  auto memory = make_line_memory({pairs.port(), ids.port()}, options, number);
  const Scene<N> scene(steps, memory.store);
  rtl::TraversalUnit<CountingBits, N> unit({ray_channel, candidates, replies, reports, pairs.port(), ids.port()},
                                           scene.tree, kRaysAtOnce);
  LeafAnswerer answerer(
      candidates, replies, [&](const rtl::RayCandidate& candidate) { return look_up(scene.hits, candidate); },
      sink_stalls(options, number + 1));
  Source<rtl::RayJob> source(ray_channel, scene.rays, source_stalls(options, number));
  Sink<rtl::RayReport> sink(reports, sink_stalls(options, number));
  rtl::Clock clock(source, ray_channel, unit, pairs, ids, memory, candidates, answerer, replies, reports, sink);
  Runner runner(clock, options);
  const bool finished =
      runner.run_until([&] { return sink.items.size() >= scene.rays.size() || answerer.met.size() > wanted; },
                       [&] { return memory.reads + candidates.pops() + replies.pops() + sink.items.size(); });
  runner.drain();
  add_events(scene.rays, std::move(answerer.met), std::move(sink.items), responses);
  responses.cycles += clock.cycle();
  return finished;
}

}  // namespace

UnitDriver traversal_unit_driver() {
  return {"traversal_unit", [](const vectors::VectorSet& set, const RunOptions& options) {
            return with_packed_bits(set.parameters().bits, [&]<int N>(std::integral_constant<int, N>) {
              Responses responses(sizeof(TraversalEvent));
              for (std::size_t index = 0; index < set.size(); ++index) {
                const auto steps = typed_stimuli<TraversalStep<N>, TraversalEvent>(set, set.stimulus_range(index));
                const std::size_t wanted = set.response_range(index).size;
                responses.end_case(!run_steps<N>(steps, wanted, options, set.head(index).id, responses));
              }
              return responses;
            });
          }};
}

}  // namespace cbvh::testbench
