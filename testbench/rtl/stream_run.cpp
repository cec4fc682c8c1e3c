// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/rtl/stream_run.h"

#include <algorithm>

#include "rtl_model/compress/lazy_treelet_collector.h"
#include "rtl_model/compress/stream_compressor.h"
#include "rtl_model/memory/fixed_latency_memory.h"
#include "testbench/rtl/counting_bits.h"
#include "testbench/rtl/memory_port.h"
#include "testbench/rtl/ports.h"
#include "testbench/rtl/run.h"

namespace cbvh::testbench {

namespace {

template <int N, template <class, int> class CollectorOf>
StreamTrace<N> run(int levels, std::span<const rtl::StreamJob> jobs, const RunOptions& options, std::uint64_t number,
                   bool log_writes) {
  const auto trees =
      static_cast<std::size_t>(std::count_if(jobs.begin(), jobs.end(), [](const auto& job) { return bool(job.root); }));
  rtl::Channel<rtl::StreamJob> job_channel;
  rtl::Channel<rtl::MemoryRequest<N>> requests;
  rtl::Channel<rtl::MemoryLine<N>> lines;
  rtl::Channel<rtl::StreamReport> report_channel;
  rtl::StreamCompressor<CountingBits, N, CollectorOf> unit(job_channel, requests, lines, report_channel, levels);
  auto memory = make_memory(requests, lines, options, number);
  AcceptanceMonitor<rtl::StreamJob> acceptance(job_channel);
  WriteMonitor<N> writes(requests, log_writes);
  SendMonitor<rtl::StreamReport> sent(report_channel);
  Source<rtl::StreamJob> source(job_channel, jobs, source_stalls(options, number));
  Sink<rtl::StreamReport> sink(report_channel, sink_stalls(options, number));
  rtl::Clock clock(source, job_channel, acceptance, unit, requests, writes, memory, lines, report_channel, sent, sink);
  Runner runner(clock, options);
  StreamTrace<N> trace;
  trace.hung = !runner.run_until([&] { return acceptance.count() == jobs.size() && sink.items.size() >= trees; },
                                 [&] { return acceptance.count() + sink.items.size() + memory.reads + memory.writes; });
  runner.drain();
  for (std::size_t i = 0; i < sink.items.size(); ++i)
    trace.reports.push_back({sent.cycles[i], sink.cycles[i], sink.items[i]});
  for (auto& [cycle, request] : writes.writes) trace.writes.push_back({cycle, request});
  trace.memory = std::move(memory.pairs);
  trace.started = acceptance.first();
  trace.cycles = clock.cycle();
  return trace;
}

}  // namespace

template <int N>
StreamTrace<N> run_stream(Collector collector, int levels, std::span<const rtl::StreamJob> jobs,
                          const RunOptions& options, std::uint64_t number, bool log_writes) {
  return collector == Collector::full ? run<N, rtl::TreeletCollector>(levels, jobs, options, number, log_writes)
                                      : run<N, rtl::LazyTreeletCollector>(levels, jobs, options, number, log_writes);
}

#define CBVH_INSTANTIATE(N)                                                                                 \
  template StreamTrace<N> run_stream<N>(Collector, int, std::span<const rtl::StreamJob>, const RunOptions&, \
                                        std::uint64_t, bool);
CBVH_INSTANTIATE(2)
CBVH_INSTANTIATE(4)
CBVH_INSTANTIATE(6)
CBVH_INSTANTIATE(8)
#ifndef CBVH_FEW_BITS
CBVH_INSTANTIATE(3)
CBVH_INSTANTIATE(5)
CBVH_INSTANTIATE(7)
#endif
#undef CBVH_INSTANTIATE

}  // namespace cbvh::testbench
