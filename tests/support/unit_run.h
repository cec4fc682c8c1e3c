// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "rtl_model/kernel/clock.h"
#include "rtl_model/kernel/stall.h"

/// Runs one module with one input and one output channel, to see its responses and when they came.
namespace cbvh::testing {

struct Disturbance {
  bool source_stalls = false;
  bool sink_stalls = false;
  bool shuffled_order = false;
  std::uint64_t seed = 1;
};

/// {nothing, source stalls, sink stalls, both}, each with the given order of evaluation as well.
inline std::vector<Disturbance> stall_matrix(std::uint64_t seed = 1) {
  std::vector<Disturbance> matrix;
  for (int i = 0; i < 8; ++i)
    matrix.push_back({(i & 1) != 0, (i & 2) != 0, (i & 4) != 0, seed + static_cast<unsigned>(i)});
  return matrix;
}

template <class Response>
struct Observed {
  std::vector<Response> responses;
  std::vector<std::uint64_t> accepted;  ///< cycle in which the unit took each stimulus
  std::vector<std::uint64_t> given;     ///< cycle in which each response could be taken

  /// Cycles from the acceptance of each stimulus to the response of the same number.
  std::vector<std::uint64_t> latencies() const {
    std::vector<std::uint64_t> result;
    for (std::size_t i = 0; i < responses.size(); ++i) result.push_back(given[i] - accepted.at(i));
    return result;
  }
};

/// `make_unit(jobs, results)` makes the module. Ends when as many responses came as there were stimuli, or after too
/// many cycles.
template <class Stimulus, class Response, class Make>
Observed<Response> run_unit(std::span<const Stimulus> stimuli, const Disturbance& disturbance, Make&& make_unit,
                            std::size_t wanted = ~std::size_t{0}) {
  rtl::Channel<Stimulus> jobs;
  rtl::Channel<Response> results;
  auto unit = make_unit(jobs, results);
  rtl::Clock clock(*unit, jobs, results);
  rtl::SplitMix64 order(disturbance.seed);
  auto source =
      disturbance.source_stalls ? rtl::StallPattern::bursts(disturbance.seed + 100) : rtl::StallPattern::never();
  auto sink = disturbance.sink_stalls ? rtl::StallPattern::bursts(disturbance.seed + 200) : rtl::StallPattern::never();

  Observed<Response> observed;
  wanted = std::min(wanted, stimuli.size());
  std::size_t sent = 0;
  const std::uint64_t deadline = 1000 + 100 * stimuli.size();
  while (observed.responses.size() < wanted && clock.cycle() < deadline) {
    if (!source.stalls() && sent < stimuli.size() && jobs.can_push()) jobs.push(stimuli[sent++]);
    if (!sink.stalls() && results.can_pop()) {
      observed.given.push_back(clock.cycle());
      observed.responses.push_back(results.pop());
    }
    const std::uint64_t cycle = clock.cycle();
    if (disturbance.shuffled_order) {
      clock.step_shuffled(order);
    } else {
      clock.step();
    }
    if (jobs.pops() > observed.accepted.size()) observed.accepted.push_back(cycle);
  }
  return observed;
}

}  // namespace cbvh::testing
