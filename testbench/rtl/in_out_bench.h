// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cassert>
#include <functional>

#include "testbench/rtl/ports.h"
#include "testbench/rtl/run.h"
#include "testbench/rtl/unit_driver.h"
#include "vectors/format/payload_codec.h"

/// Benches of units with one channel in and one out.
namespace cbvh::testbench {

constexpr std::uint32_t to_latency(std::uint64_t from, std::uint64_t to) {
  return static_cast<std::uint32_t>(to - from);
}

/// From when latencies count.
enum class Origin { own_job, first_job };

template <class Job, class Result>
struct InOutTrace {
  std::vector<Result> results;
  std::vector<std::uint32_t> latencies;  ///< of each result, from when the unit took the job that `origin` says
  std::uint64_t cycles = 0;
  bool hung = false;
};

/// Sends all jobs through one fresh instance, and waits until as many results as wanted are back. make(jobs, results)
/// gives it.
template <class Job, class Result, class Make>
InOutTrace<Job, Result> run_in_out(Make&& make, std::span<const Job> jobs, std::size_t wanted, Origin origin,
                                   const RunOptions& options, std::uint64_t number) {
  rtl::Channel<Job> job_channel;
  rtl::Channel<Result> result_channel;
  auto unit = make(job_channel, result_channel);
  AcceptanceMonitor<Job> acceptance(job_channel);
  Source<Job> source(job_channel, jobs, source_stalls(options, number));
  Sink<Result> sink(result_channel, sink_stalls(options, number));
  acceptance.reserve(jobs.size());
  sink.items.reserve(wanted);
  sink.cycles.reserve(wanted);
  rtl::Clock clock(source, job_channel, acceptance, unit, result_channel, sink);
  Runner runner(clock, options);
  InOutTrace<Job, Result> trace;
  trace.hung = !runner.run_until([&] { return acceptance.count() == jobs.size() && sink.items.size() >= wanted; },
                                 [&] { return acceptance.count() + sink.items.size(); });
  runner.drain();
  trace.results = std::move(sink.items);
  trace.latencies.reserve(trace.results.size());
  for (std::size_t i = 0; i < trace.results.size(); ++i) {
    const std::size_t job = origin == Origin::first_job ? 0 : i;
    trace.latencies.push_back(job < acceptance.count() ? to_latency(acceptance[job], sink.cycles[i]) : 0);
  }
  trace.cycles = clock.cycle();
  return trace;
}

/// Stimuli of a set whose types the caller knows.
template <class Job, class Result>
std::span<const Job> typed_stimuli(const vectors::VectorSet& set, vectors::VectorSet::Range range) {
  assert(&set.stimulus_codec() == &vectors::payload_codec<Job>());
  assert(&set.response_codec() == &vectors::payload_codec<Result>());
  return range.size == 0 ? std::span<const Job>()
                         : std::span(static_cast<const Job*>(set.stimulus_at(range.begin)), range.size);
}

/// Units without state: all cases back to back through one instance, as fast as it takes them.
template <class Job, class Result, class Make>
Responses stream_cases(Make&& make, const vectors::VectorSet& set, const RunOptions& options) {
  const auto jobs = typed_stimuli<Job, Result>(set, {0, set.stimulus_count()});
  const auto trace =
      run_in_out<Job, Result>(make, jobs, jobs.size(), Origin::own_job, options, set.empty() ? 0 : set.head(0).id);
  Responses responses(sizeof(Result));
  responses.reserve(trace.results.size());
  responses.cycles = trace.cycles;
  if (jobs.empty()) return responses;
  responses.add(trace.results.data(), trace.latencies);
  for (std::size_t i = 0; i + 1 < jobs.size(); ++i) {
    const bool given = i < trace.results.size();
    responses.end_case(given ? 1 : 0, trace.hung && !given);
  }
  responses.end_case(trace.hung && trace.results.size() < jobs.size());  // a surplus response is the last case's
  return responses;
}

/// Units with state: each case through an instance of its own. Latencies count from when the unit took the first
/// stimulus.
template <class Job, class Result, class Make>
Responses run_episodes(Make&& make, const vectors::VectorSet& set, const RunOptions& options) {
  Responses responses(sizeof(Result));
  responses.reserve(set.response_count());
  for (std::size_t index = 0; index < set.size(); ++index) {
    const auto jobs = typed_stimuli<Job, Result>(set, set.stimulus_range(index));
    const auto trace = run_in_out<Job, Result>(make, jobs, set.response_range(index).size, Origin::first_job, options,
                                               set.head(index).id);
    responses.add(trace.results.data(), trace.latencies);
    responses.end_case(trace.hung);
    responses.cycles += trace.cycles;
  }
  return responses;
}

}  // namespace cbvh::testbench
