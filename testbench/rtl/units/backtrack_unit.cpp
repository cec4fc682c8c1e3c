// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "rtl_model/compress/backtrack_unit.h"

#include "testbench/rtl/counting_bits.h"
#include "testbench/rtl/in_out_bench.h"
#include "testbench/rtl/memory_port.h"
#include "vectors/payloads.h"

namespace cbvh::testbench {

namespace {

using Done = rtl::UInt<32>;

/// Writes and ends of jobs in the order in which they left the unit.
template <int N>
void add_events(const std::vector<typename WriteMonitor<N>::Write>& writes, const Sink<Done>& done,
                const std::vector<std::uint64_t>& sent, std::uint64_t start, Responses& responses) {
  std::size_t next_done = 0;
  const auto add_done = [&] {
    const vectors::BacktrackEvent<N> event{rtl::UInt<1>(1), {}, {}, done.items[next_done]};
    responses.add(&event, to_latency(start, done.cycles[next_done++]));
  };
  for (const auto& [cycle, request] : writes) {
    while (next_done < done.items.size() && sent[next_done] < cycle) add_done();
    for (std::size_t slot = 0; slot < rtl::kPairsPerLine; ++slot) {
      if ((request.mask.value() >> slot & 1U) == 0) continue;
      const vectors::BacktrackEvent<N> event{
          rtl::UInt<1>(0), rtl::Pointer(request.line.value() * rtl::kPairsPerLine + slot), request.pairs[slot], {}};
      responses.add(&event, to_latency(start, cycle));
    }
  }
  while (next_done < done.items.size()) add_done();
}

/// One episode. Jobs follow each other without a pause; what memory holds changes when the job before has ended.
template <int N>
bool run_steps(std::span<const vectors::BacktrackStep<N>> steps, const RunOptions& options, std::uint64_t number,
               Responses& responses) {
  std::vector<rtl::RepairJob> repair_jobs;
  for (const auto& step : steps) {
    if (step.repair) repair_jobs.push_back(step.job);
  }
  rtl::Channel<rtl::RepairJob> jobs;
  rtl::Channel<rtl::MemoryRequest<N>> requests;
  rtl::Channel<rtl::MemoryLine<N>> lines;
  rtl::Channel<Done> done_channel;
  rtl::BacktrackUnit<CountingBits, N> unit(jobs, requests, lines, done_channel);
  auto memory = make_memory(requests, lines, options, number);
  AcceptanceMonitor<rtl::RepairJob> acceptance(jobs);
  WriteMonitor<N> writes(requests);
  Source<rtl::RepairJob> source(jobs, repair_jobs, source_stalls(options, number));
  Sink<Done> sink(done_channel, sink_stalls(options, number));
  SendMonitor<Done> sent(done_channel);
  rtl::Clock clock(source, jobs, acceptance, unit, requests, writes, memory, lines, done_channel, sent, sink);
  Runner runner(clock, options);
  std::size_t next_step = 0;
  std::size_t jobs_passed = 0;
  const auto fill_memory_for = [&](std::size_t job) {
    for (; next_step < steps.size() && jobs_passed <= job; ++next_step) {
      const auto& step = steps[next_step];
      if (step.repair) {
        ++jobs_passed;
        continue;
      }
      const std::size_t index = step.index.value();
      if (memory.pairs.size() <= index) memory.pairs.resize(index + 1);
      memory.pairs[index] = step.pair;
    }
  };
  const bool finished = runner.run_until(
      [&] {
        fill_memory_for(sent.cycles.size());
        return sink.items.size() >= repair_jobs.size();
      },
      [&] { return sink.items.size() + memory.reads + memory.writes; });
  runner.drain();
  add_events<N>(writes.writes, sink, sent.cycles, acceptance.first(), responses);
  responses.cycles += clock.cycle();
  return finished;
}

}  // namespace

UnitDriver backtrack_unit_driver() {
  return {"backtrack_unit", [](const vectors::VectorSet& set, const RunOptions& options) {
            return vectors::with_bits(set.parameters().bits, [&]<int N>(std::integral_constant<int, N>) {
              using Step = vectors::BacktrackStep<N>;
              using Event = vectors::BacktrackEvent<N>;
              Responses responses(sizeof(Event));
              for (std::size_t index = 0; index < set.size(); ++index) {
                const auto steps = typed_stimuli<Step, Event>(set, set.stimulus_range(index));
                responses.end_case(!run_steps<N>(steps, options, set.head(index).id, responses));
              }
              return responses;
            });
          }};
}

}  // namespace cbvh::testbench
