// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "rtl_model/lbvh/run_writer.h"

#include "testbench/rtl/in_out_bench.h"
#include "testbench/rtl/line_memory.h"
#include "vectors/lbvh_payloads.h"

namespace cbvh::testbench {

namespace {

/// Lines and runs in the order in which the unit sent them.
void add_events(const std::vector<rtl::LineRequest>& lines, const std::vector<std::uint64_t>& lines_sent,
                const std::vector<rtl::RunDescriptor>& runs, const std::vector<std::uint64_t>& runs_sent,
                std::uint64_t start, Responses& responses) {
  std::size_t next_run = 0;
  const auto add_run = [&] {
    const vectors::RunEvent event{rtl::UInt<1>(1), {}, runs[next_run]};
    responses.add(&event, to_latency(start, runs_sent[next_run++]));
  };
  for (std::size_t i = 0; i < lines.size(); ++i) {
    while (next_run < runs.size() && runs_sent[next_run] < lines_sent[i]) add_run();
    const vectors::RunEvent event{{}, lines[i], {}};
    responses.add(&event, to_latency(start, lines_sent[i]));
  }
  while (next_run < runs.size()) add_run();
}

/// One episode: all passes follow each other without a pause.
bool run_steps(std::span<const vectors::RunStep> steps, const RunOptions& options, std::uint64_t number,
               Responses& responses) {
  std::vector<rtl::SortItem> records;
  std::vector<rtl::RunArea> passes;
  std::size_t runs = 0;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (i == 0 || steps[i - 1].item.last) passes.push_back(steps[i].area);
    records.push_back(steps[i].item);
    runs += steps[i].item.last_of_run.value() | steps[i].item.last.value();
  }
  rtl::Channel<rtl::RunArea> areas;
  rtl::Channel<rtl::SortItem> items;
  rtl::Channel<rtl::LineRequest> requests;
  rtl::Channel<rtl::LineData> answers;
  rtl::Channel<rtl::RunDescriptor> descriptors;
  rtl::RunWriter unit(areas, items, requests, answers, descriptors);
  auto memory = make_line_memory({{&requests, &answers}}, options, number);
  AcceptanceMonitor<rtl::RunArea> acceptance(areas);
  SendMonitor<rtl::LineRequest> lines_sent(requests);
  LineWriteMonitor lines(requests);
  SendMonitor<rtl::RunDescriptor> runs_sent(descriptors);
  Source<rtl::RunArea> area_source(areas, passes, source_stalls(options, number + 1));
  Source<rtl::SortItem> item_source(items, records, source_stalls(options, number));
  Sink<rtl::RunDescriptor> sink(descriptors, sink_stalls(options, number));
  rtl::Clock clock(area_source, areas, acceptance, item_source, items, unit, requests, lines_sent, lines, memory,
                   answers, descriptors, runs_sent, sink);
  Runner runner(clock, options);
  const bool finished = runner.run_until([&] { return sink.items.size() >= runs; },
                                         [&] { return items.pops() + sink.items.size() + memory.writes; });
  runner.drain();
  add_events(lines.writes, lines_sent.cycles, sink.items, runs_sent.cycles, acceptance.first(), responses);
  responses.cycles += clock.cycle();
  return finished;
}

}  // namespace

UnitDriver run_writer_driver() {
  return {"run_writer", [](const vectors::VectorSet& set, const RunOptions& options) {
            Responses responses(sizeof(vectors::RunEvent));
            for (std::size_t index = 0; index < set.size(); ++index) {
              const auto steps = typed_stimuli<vectors::RunStep, vectors::RunEvent>(set, set.stimulus_range(index));
              responses.end_case(!run_steps(steps, options, set.head(index).id, responses));
            }
            return responses;
          }};
}

}  // namespace cbvh::testbench
