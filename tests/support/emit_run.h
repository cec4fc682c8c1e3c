// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "golden/build/lbvh.h"
#include "golden/build/morton.h"
#include "golden/scene/load.h"
#include "rtl_model/kernel/clock.h"
#include "rtl_model/kernel/stall.h"
#include "rtl_model/lbvh/hierarchy_emitter.h"
#include "tests/support/unit_run.h"
#include "vectors/convert.h"

/// Sorted records through the hierarchy emitter.
namespace cbvh::testing {

/// The primitives of a scene in order of their codes.
inline std::vector<golden::CodedBox> sorted_boxes(const std::string& scene) {
  const auto boxes = golden::triangle_boxes(golden::load_scene(scene));
  golden::Box around = boxes.front();
  for (const auto& box : boxes) around = golden::unite(around, box);
  std::vector<golden::CodedBox> sorted;
  for (const auto& box : boxes) {
    sorted.push_back({box, golden::morton_code(box, around), static_cast<std::uint32_t>(sorted.size())});
  }
  std::stable_sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) { return a.code < b.code; });
  return sorted;
}

inline rtl::SortRecord sort_record(const golden::CodedBox& item) {
  return {vectors::float_box(item.box), rtl::UInt<rtl::kMortonBits>(item.code), rtl::Pointer(item.id)};
}

inline std::vector<rtl::SortItem> sort_items(std::span<const golden::CodedBox> sorted) {
  std::vector<rtl::SortItem> items;
  for (const auto& item : sorted) {
    const rtl::UInt<1> last(items.size() + 1 == sorted.size());
    items.push_back({sort_record(item), last, last});
  }
  return items;
}

struct EmitRun {
  std::vector<rtl::StreamJob> jobs;
  std::vector<rtl::IdEntry> ids;
  std::vector<rtl::EmitReport> reports;
  std::uint64_t cycles = 0;  ///< from the first record offered to the last report
  bool finished = false;
};

/// Until as many reports have come as items are marked last.
inline EmitRun run_emitter(std::span<const rtl::SortItem> items, const rtl::SceneRegisters& registers,
                           const Disturbance& disturbance = {}) {
  rtl::Channel<rtl::SortItem> in;
  rtl::Channel<rtl::StreamJob> jobs;
  rtl::Channel<rtl::IdEntry> ids;
  rtl::Channel<rtl::EmitReport> reports;
  rtl::HierarchyEmitter<rtl::MachineBits> unit(in, jobs, ids, reports, registers);
  rtl::Clock clock(unit, in, jobs, ids, reports);
  rtl::SplitMix64 order(disturbance.seed);
  const auto stalls = [](bool wanted, std::uint64_t seed) {
    return wanted ? rtl::StallPattern::bursts(seed) : rtl::StallPattern::never();
  };
  auto source = stalls(disturbance.source_stalls, disturbance.seed + 100);
  rtl::StallPattern sinks[] = {stalls(disturbance.sink_stalls, disturbance.seed + 200),
                               stalls(disturbance.sink_stalls, disturbance.seed + 300),
                               stalls(disturbance.sink_stalls, disturbance.seed + 400)};
  const auto take = [&](std::size_t sink, auto& channel, auto& into) {
    if (!sinks[sink].stalls() && channel.can_pop()) into.push_back(channel.pop());
  };
  EmitRun run;
  const auto wanted = static_cast<std::size_t>(
      std::count_if(items.begin(), items.end(), [](const auto& item) { return bool(item.last); }));
  std::size_t sent = 0;
  const std::uint64_t deadline = 1000 + 50 * items.size();
  while (run.reports.size() < wanted && clock.cycle() < deadline) {
    if (!source.stalls() && sent < items.size() && in.can_push()) in.push(items[sent++]);
    take(0, jobs, run.jobs);
    take(1, ids, run.ids);
    take(2, reports, run.reports);
    if (disturbance.shuffled_order) {
      clock.step_shuffled(order);
    } else {
      clock.step();
    }
  }
  run.cycles = clock.cycle();
  for (int drain = 0; drain < 64; ++drain) {
    take(0, jobs, run.jobs);
    take(1, ids, run.ids);
    take(2, reports, run.reports);
    clock.step();
  }
  run.finished = run.reports.size() == wanted;
  return run;
}

}  // namespace cbvh::testing
