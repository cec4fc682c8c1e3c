// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "rtl_model/lbvh/merge_config.h"
#include "vectors/generate/sorted_runs.h"
#include "vectors/lbvh_payloads.h"
#include "vectors/unit.h"

namespace cbvh::vectors {

/// The merger that the cases are made for: small, so that few runs are too many. A scratchpad for four runs of four
/// records.
constexpr rtl::MergeConfig kMergerConfig{512, 4, 16, 8, 256};
constexpr std::size_t kMergerRuns = kMergerConfig.most_runs();
static_assert(kMergerRuns == 4);

/// Sorted runs, which lie in memory one after the other, to a sorted scene. What goes back to memory in between is part
/// of the answer. Cycles depend on memory: none is stated.
struct RunMerger {
  using Stimulus = rtl::SortItem;
  using Response = MergeEvent;
  static constexpr std::string_view kName = "run_merger";
  static constexpr std::string_view kSummary = "sorted runs in memory to a sorted scene (here up to 4 runs at once)";
  static constexpr std::string_view kLatencyText = "1 a record, if no buffer is dry";
  static constexpr bool kStateful = true;
  static constexpr bool kTreelet = false;
  static constexpr const auto& kClasses = kMergeClasses;

  static std::vector<Stimulus> generate(std::size_t case_class, Random& random, const Parameters&) {
    return make_sorted_runs(case_class, random, kMergerRuns);
  }

  /// One scene an episode.
  static std::vector<Expected<Response>> respond(std::span<const Stimulus> items, const Parameters&) {
    std::vector<Run> runs = runs_of(items);
    std::vector<Expected<Response>> events;
    while (runs.size() > kMergerRuns) {
      runs = pass(runs, events);
      events.back().response.item.last = rtl::UInt<1>(1);
    }
    add(merged(runs), false, events);
    events.back().response.item.last = rtl::UInt<1>(1);
    return events;
  }

 private:
  using Run = std::vector<rtl::SortRecord>;

  static std::vector<Run> runs_of(std::span<const Stimulus> items) {
    std::vector<Run> runs(1);
    for (const Stimulus& item : items) {
      const bool last = &item == &items.back();
      if (bool(item.last) != last) throw golden::InputError("last", "want it set in the last record and in no other");
      if (!runs.back().empty() && item.record.code.value() < runs.back().back().code.value()) {
        throw golden::InputError("code", "a run is not sorted");
      }
      runs.back().push_back(item.record);
      if (bool(item.last_of_run) && !last) runs.emplace_back();
    }
    return runs;
  }
  static Run merged(std::span<const Run> runs) {
    Run all;
    for (const Run& run : runs) all.insert(all.end(), run.begin(), run.end());
    std::stable_sort(all.begin(), all.end(),
                     [](const auto& a, const auto& b) { return a.code.value() < b.code.value(); });
    return all;
  }
  static void add(const Run& run, bool rewritten, std::vector<Expected<Response>>& events) {
    for (const rtl::SortRecord& record : run) {
      events.push_back({{rtl::UInt<1>(rewritten), {record, {}, {}}}, kLatencyNotStated});
    }
    events.back().response.item.last_of_run = rtl::UInt<1>(1);
  }
  /// From the first run on, merges as many as can be at once until the rest is few enough, or no run is left.
  static std::vector<Run> pass(std::span<const Run> runs, std::vector<Expected<Response>>& events) {
    std::vector<Run> result;
    std::size_t surplus = runs.size() - kMergerRuns;
    while (surplus > 0 && !runs.empty()) {
      const std::size_t group = std::min({kMergerRuns, surplus + 1, runs.size()});
      result.push_back(merged(runs.first(group)));
      add(result.back(), true, events);
      runs = runs.subspan(group);
      surplus -= group - 1;
    }
    result.insert(result.end(), runs.begin(), runs.end());
    return result;
  }
};

}  // namespace cbvh::vectors
