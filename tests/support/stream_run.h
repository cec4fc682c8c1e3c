// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "golden/build/float_tree.h"
#include "rtl_model/compress/stream_compressor.h"
#include "rtl_model/kernel/clock.h"
#include "rtl_model/kernel/stall.h"
#include "rtl_model/memory/fixed_latency_memory.h"
#include "tests/support/unit_run.h"
#include "vectors/convert.h"

/// Runs a float tree through the stream compressor and its memory.
namespace cbvh::testing {

template <int N>
struct StreamRun {
  std::vector<golden::CompressedPair> pairs;  ///< memory at the end
  rtl::StreamReport report;
  bool finished = false;
  std::uint64_t cycles = 0;  ///< from the first pair offered to the report
  std::uint64_t reads = 0;
  std::uint64_t writes = 0;
};

template <int N, template <class, int> class Collector = rtl::TreeletCollector, class Bits = rtl::MachineBits>
StreamRun<N> run_stream(const golden::FloatTree& tree, const rtl::SceneRegisters& registers, int levels,
                        const Disturbance& disturbance = {}, unsigned jitter = 0) {
  rtl::Channel<rtl::StreamJob> jobs;
  rtl::Channel<rtl::MemoryRequest<N>> requests;
  rtl::Channel<rtl::MemoryLine<N>> lines;
  rtl::Channel<rtl::StreamReport> reports;
  rtl::StreamCompressor<Bits, N, Collector> unit(jobs, requests, lines, reports, levels);
  rtl::FixedLatencyMemory<N> memory(requests, lines, 4, jitter, disturbance.seed);
  rtl::Clock clock(unit, memory, jobs, requests, lines, reports);
  rtl::SplitMix64 order(disturbance.seed);
  auto source =
      disturbance.source_stalls ? rtl::StallPattern::bursts(disturbance.seed + 100) : rtl::StallPattern::never();
  auto sink = disturbance.sink_stalls ? rtl::StallPattern::bursts(disturbance.seed + 200) : rtl::StallPattern::never();

  StreamRun<N> run;
  std::size_t sent = 0;
  const std::uint64_t deadline = 10000 + 400 * tree.pairs.size();
  while (!run.finished && clock.cycle() < deadline) {
    if (!source.stalls() && sent < tree.pairs.size() && jobs.can_push())
      jobs.push(vectors::stream_job(tree, sent++, registers));
    if (!sink.stalls() && reports.can_pop()) {
      run.report = reports.pop();
      run.finished = true;
      run.cycles = clock.cycle();
    }
    if (disturbance.shuffled_order) {
      clock.step_shuffled(order);
    } else {
      clock.step();
    }
  }
  for (int drain = 0; drain < 8; ++drain) clock.step();
  memory.pairs.resize(tree.pairs.size());
  for (const auto& pair : memory.pairs) run.pairs.push_back(vectors::compressed_pair(pair));
  run.reads = memory.reads;
  run.writes = memory.writes;
  return run;
}

}  // namespace cbvh::testing
