// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "rtl_model/kernel/clock.h"
#include "rtl_model/kernel/stall.h"
#include "rtl_model/lbvh/run_merger.h"
#include "rtl_model/memory/ideal_line_memory.h"
#include "tests/support/unit_run.h"

/// Sorted runs in memory, and the run merger working on them.
namespace cbvh::testing {

using SortedRun = std::vector<rtl::SortRecord>;

inline rtl::SortRecord numbered_record(std::uint64_t code, std::uint64_t id) {
  rtl::SortRecord record;
  record.code = rtl::UInt<rtl::kMortonBits>(code);
  record.id = rtl::Pointer(id);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    record.box.lower[axis] = rtl::Float32::of_raw(id * 6 + axis);
    record.box.upper[axis] = rtl::Float32::of_raw(id * 6 + 3 + axis);
  }
  return record;
}

/// Runs of the given sizes with codes below `codes`; ids count the records.
inline std::vector<SortedRun> random_runs(std::span<const std::size_t> sizes, std::uint64_t codes, std::uint64_t seed) {
  rtl::SplitMix64 random(seed);
  std::vector<SortedRun> runs;
  std::uint64_t id = 0;
  for (const std::size_t size : sizes) {
    std::vector<std::uint64_t> run_codes(size);
    for (auto& code : run_codes) code = random.below(codes);
    std::sort(run_codes.begin(), run_codes.end());
    SortedRun& run = runs.emplace_back();
    for (const auto code : run_codes) run.push_back(numbered_record(code, id++));
  }
  return runs;
}

/// All records, sorted by code alone; equal codes keep their order.
inline std::vector<rtl::SortRecord> stable_sort_of(const std::vector<SortedRun>& runs) {
  std::vector<rtl::SortRecord> all;
  for (const SortedRun& run : runs) all.insert(all.end(), run.begin(), run.end());
  std::stable_sort(all.begin(), all.end(),
                   [](const auto& a, const auto& b) { return a.code.value() < b.code.value(); });
  return all;
}

/// Puts runs into memory, each from a line on, without a clock: what a run writer leaves there.
class RunStore {
 public:
  explicit RunStore(rtl::LineStore& store) : store_(store) {}

  void add(const rtl::SortRecord& record) {
    rtl::LineWords words{};
    rtl::put_record(record, words, 0);
    for (std::size_t i = 0; i < rtl::kWordsPerRecord; ++i) {
      store_.poke(first_line_ * rtl::kWordsPerLine + records_ * rtl::kWordsPerRecord + i,
                  static_cast<std::uint32_t>(words[i].value()));
    }
    ++records_;
  }
  rtl::RunDescriptor end(bool last) {
    const rtl::RunDescriptor run{rtl::LineAddress(first_line_), rtl::UInt<rtl::kPointerBits + 1>(records_),
                                 rtl::UInt<1>(last)};
    first_line_ += (records_ + 1) / rtl::kRecordsPerLine;
    records_ = 0;
    return run;
  }

 private:
  rtl::LineStore& store_;
  std::uint64_t first_line_ = 3;
  std::uint64_t records_ = 0;
};

struct MergeRun {
  std::vector<rtl::SortItem> sorted;
  std::vector<std::vector<rtl::SortItem>> rewritten;  ///< pass by pass
  std::vector<std::uint64_t> given;                   ///< the cycle of each sorted item
  std::vector<std::uint64_t> lines_read;              ///< addresses, in order
  std::uint64_t most_under_way = 0;                   ///< lines
  std::uint64_t cycles = 0;
  bool finished = false;
};

/// Scene after scene. The descriptors of one go in when the one before has left; whatever is rewritten is written to
/// memory and described at once.
inline MergeRun run_merges(const std::vector<std::vector<SortedRun>>& scenes, const rtl::MergeConfig& config,
                           const Disturbance& disturbance = {}, unsigned latency = 4, unsigned jitter = 0) {
  rtl::Channel<rtl::RunDescriptor> descriptors;
  rtl::Channel<rtl::LineRequest> requests;
  rtl::Channel<rtl::LineData> answers;
  rtl::Channel<rtl::SortItem> sorted;
  rtl::Channel<rtl::SortItem> rewritten;
  rtl::RunMerger<rtl::MachineBits> unit(descriptors, requests, answers, sorted, rewritten, config);
  rtl::IdealLineMemory memory({{&requests, &answers}}, 1U << 22, latency, jitter, disturbance.seed);
  rtl::Clock clock(unit, memory, descriptors, requests, answers, sorted, rewritten);
  rtl::SplitMix64 order(disturbance.seed);
  const auto stalls = [](bool wanted, std::uint64_t seed) {
    return wanted ? rtl::StallPattern::bursts(seed) : rtl::StallPattern::never();
  };
  auto source = stalls(disturbance.source_stalls, disturbance.seed + 100);
  auto sink = stalls(disturbance.sink_stalls, disturbance.seed + 200);
  auto rewriter = stalls(disturbance.sink_stalls, disturbance.seed + 300);

  RunStore store(memory.store);
  std::vector<rtl::RunDescriptor> waiting;
  std::size_t records = 0;
  auto scene = scenes.begin();
  const auto store_scene = [&] {
    for (const SortedRun& run : *scene) {
      for (const auto& record : run) store.add(record);
      waiting.push_back(store.end(&run == &scene->back()));
    }
  };
  for (const auto& runs : scenes) {
    for (const SortedRun& run : runs) records += run.size();
  }
  MergeRun result;
  result.rewritten.emplace_back();
  std::size_t sent = 0;
  store_scene();
  const std::uint64_t deadline = 20000 + (100 + latency + jitter) * records;
  while (!result.finished && clock.cycle() < deadline) {
    if (!source.stalls() && sent < waiting.size() && descriptors.can_push()) descriptors.push(waiting[sent++]);
    if (!rewriter.stalls() && rewritten.can_pop()) {
      const auto& item = result.rewritten.back().emplace_back(rewritten.pop());
      store.add(item.record);
      if (item.last_of_run) waiting.push_back(store.end(bool(item.last)));
      if (item.last) result.rewritten.emplace_back();
    }
    if (!sink.stalls() && sorted.can_pop()) {
      result.given.push_back(clock.cycle());
      result.sorted.push_back(sorted.pop());
      if (result.sorted.back().last && ++scene != scenes.end()) store_scene();
      result.finished = scene == scenes.end();
    }
    const std::uint64_t before = requests.pops();
    if (disturbance.shuffled_order) {
      clock.step_shuffled(order);
    } else {
      clock.step();
    }
    if (requests.pops() > before) result.lines_read.push_back(requests.last_popped().line.value());
    result.most_under_way = std::max(result.most_under_way, requests.pushes() - answers.pops());
  }
  result.cycles = clock.cycle();
  result.rewritten.pop_back();
  for (int drain = 0; drain < 64; ++drain) clock.step();
  result.finished = result.finished && !sorted.can_pop() && requests.pushes() == memory.reads;
  return result;
}

inline MergeRun run_merge(const std::vector<SortedRun>& runs, const rtl::MergeConfig& config,
                          const Disturbance& disturbance = {}, unsigned latency = 4, unsigned jitter = 0) {
  return run_merges({runs}, config, disturbance, latency, jitter);
}

}  // namespace cbvh::testing
