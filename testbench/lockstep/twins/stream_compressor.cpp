// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "rtl_model/compress/stream_compressor.h"

#include "rtl_model/bits/machine_bits.h"
#include "testbench/lockstep/in_out.h"
#include "testbench/rtl/memory_port.h"
#include "vectors/payloads.h"

namespace cbvh::testbench {

namespace {

template <int N>
Episode record(int levels, std::span<const rtl::StreamJob> items, const RunOptions& options, std::uint64_t number) {
  rtl::Channel<rtl::StreamJob> jobs;
  rtl::Channel<rtl::MemoryRequest<N>> requests;
  rtl::Channel<rtl::MemoryLine<N>> lines;
  rtl::Channel<rtl::StreamReport> reports;
  rtl::StreamCompressor<rtl::MachineBits, N> unit(jobs, requests, lines, reports, levels);
  auto memory = make_memory(requests, lines, options, number);
  Source<rtl::StreamJob> source(jobs, items, source_stalls(options, number));
  Sink<rtl::StreamReport> sink(reports, sink_stalls(options, number));
  Probe<rtl::StreamJob> job_probe(jobs, "jobs", Flow::to_unit);
  Probe<rtl::MemoryRequest<N>> memory_probe(requests, "memory", Flow::from_unit);
  Probe<rtl::MemoryLine<N>> line_probe(lines, "lines", Flow::to_unit);
  Probe<rtl::StreamReport> report_probe(reports, "reports", Flow::from_unit);
  rtl::Clock clock(source, jobs, unit, requests, memory, lines, reports, sink, job_probe, memory_probe, line_probe,
                   report_probe);
  return record_episode(clock, job_probe, memory_probe, line_probe, report_probe);
}

}  // namespace

/// All trees of a set in one episode, with memory as in the regression: reads come late when sinks stall.
LockstepTwin stream_compressor_twin() {
  return {
      "stream_compressor",
      {{6, 1}, {2, 2}},
      verilog_bits_and_levels,
      [](const vectors::Parameters& parameters, const RunOptions& options, std::uint64_t seed) {
        return with_lockstep_bits(parameters.bits, [&]<int N>(std::integral_constant<int, N>) {
          const auto set = vectors::generate_set("stream_compressor", parameters, 21, seed);
          const auto jobs = typed_stimuli<rtl::StreamJob, vectors::StreamEvent<N>>(*set, {0, set->stimulus_count()});
          return std::vector<Episode>{record<N>(parameters.treelet, jobs, options, seed)};
        });
      }};
}

}  // namespace cbvh::testbench
