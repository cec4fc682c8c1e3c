// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "vectors/faces/collector.h"
#include "vectors/faces/timing.h"
#include "vectors/generate/streams.h"
#include "vectors/unit.h"

namespace cbvh::vectors {

/// Float pairs in emission order become final pairs, and what their arrival invalidates below them. Rule 10.
template <int N, bool lazy>
struct CollectorUnit {
  using Stimulus = rtl::StreamJob;
  using Response = rtl::FinalPair<N>;
  static constexpr bool kStateful = true;
  static constexpr bool kTreelet = true;
  static constexpr const auto& kClasses = kStreamClasses;

  static std::vector<Stimulus> generate(std::size_t case_class, Random& random, const Parameters&) {
    return make_stream(case_class, random);
  }

  static std::vector<Expected<Response>> respond(std::span<const Stimulus> jobs, const Parameters& parameters) {
    const auto answers = collect(jobs, parameters.treelet, N);
    const auto cycles = collector_cycles(jobs, answers, {parameters.treelet, lazy}, N);
    std::vector<Expected<Response>> finals;
    for (std::size_t i = 0; i < answers.size(); ++i) finals.push_back({to_wires<N>(answers[i]), cycles[i]});
    return finals;
  }
};

/// The paper's: compresses every treelet anew.
template <int N>
struct TreeletCollector : CollectorUnit<N, false> {
  static constexpr std::string_view kName = "treelet_collector";
  static constexpr std::string_view kSummary = "float pairs to final pairs through treelets, each compressed anew";
  static constexpr std::string_view kLatencyText = "6 D + 1, one a cycle";
};

/// Keeps treelets compressed and repairs what a new root invalidates; the same answers.
template <int N>
struct LazyTreeletCollector : CollectorUnit<N, true> {
  static constexpr std::string_view kName = "lazy_treelet_collector";
  static constexpr std::string_view kSummary = "float pairs to final pairs through treelets, kept compressed on chip";
  static constexpr std::string_view kLatencyText = "7 + on-chip repairs";
};

}  // namespace cbvh::vectors
