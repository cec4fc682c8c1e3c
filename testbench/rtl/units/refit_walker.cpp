// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "rtl_model/refit/refit_walker.h"

#include "testbench/rtl/counting_bits.h"
#include "testbench/rtl/in_out_bench.h"
#include "vectors/line_payloads.h"

namespace cbvh::testbench {

namespace {

using vectors::WalkEvent;
using vectors::WalkStep;

bool run_steps(std::span<const WalkStep> steps, const RunOptions& options, std::uint64_t number, Responses& responses) {
  std::vector<rtl::SceneRegisters> starts;
  std::vector<rtl::TopologyPair> pairs;
  std::vector<rtl::PrimitiveBox> boxes;
  std::vector<rtl::LeafMark> marks;
  for (const WalkStep& step : steps) {
    switch (static_cast<WalkStep::Kind>(step.kind.value())) {
      case WalkStep::Kind::start:
        starts.push_back(step.registers);
        break;
      case WalkStep::Kind::pair:
        pairs.push_back(step.pair);
        break;
      case WalkStep::Kind::primitive:
        boxes.push_back(step.primitive);
        marks.push_back(step.mark);
        break;
    }
  }
  rtl::Channel<rtl::SceneRegisters> start_channel;
  rtl::Channel<rtl::TopologyPair> pair_channel;
  rtl::Channel<rtl::PrimitiveBox> box_channel;
  rtl::Channel<rtl::LeafMark> mark_channel;
  rtl::Channel<rtl::StreamJob> jobs;
  rtl::Channel<rtl::WalkReport> reports;
  rtl::RefitWalker<CountingBits> unit(start_channel, pair_channel, box_channel, mark_channel, jobs, reports);
  Source<rtl::SceneRegisters> start_source(start_channel, starts, source_stalls(options, number));
  Source<rtl::TopologyPair> pair_source(pair_channel, pairs, source_stalls(options, number + 1));
  Source<rtl::PrimitiveBox> box_source(box_channel, boxes, source_stalls(options, number + 2));
  Source<rtl::LeafMark> mark_source(mark_channel, marks, source_stalls(options, number + 3));
  Sink<rtl::StreamJob> job_sink(jobs, sink_stalls(options, number));
  Sink<rtl::WalkReport> report_sink(reports, sink_stalls(options, number + 1));
  rtl::Clock clock(start_source, pair_source, box_source, mark_source, start_channel, pair_channel, box_channel,
                   mark_channel, unit, jobs, reports, job_sink, report_sink);
  Runner runner(clock, options);
  const bool finished = runner.run_until(
      [&] { return report_sink.items.size() >= starts.size() && !jobs.can_pop(); },
      [&] { return pair_channel.pops() + box_channel.pops() + jobs.pops() + report_sink.items.size(); });
  runner.drain();
  std::size_t next_report = 0;
  for (const rtl::StreamJob& job : job_sink.items) {
    const WalkEvent event{rtl::UInt<1>(0), job, {}};
    responses.add(&event, vectors::kLatencyNotStated);
    if (!job.root || next_report == report_sink.items.size()) continue;
    const WalkEvent end{rtl::UInt<1>(1), {}, report_sink.items[next_report++]};
    responses.add(&end, vectors::kLatencyNotStated);
  }
  for (; next_report < report_sink.items.size(); ++next_report) {
    const WalkEvent end{rtl::UInt<1>(1), {}, report_sink.items[next_report]};
    responses.add(&end, vectors::kLatencyNotStated);
  }
  responses.cycles += clock.cycle();
  return finished;
}

}  // namespace

UnitDriver refit_walker_driver() {
  return {"refit_walker", [](const vectors::VectorSet& set, const RunOptions& options) {
            Responses responses(sizeof(WalkEvent));
            for (std::size_t index = 0; index < set.size(); ++index) {
              const auto steps = typed_stimuli<WalkStep, WalkEvent>(set, set.stimulus_range(index));
              responses.end_case(!run_steps(steps, options, set.head(index).id, responses));
            }
            return responses;
          }};
}

}  // namespace cbvh::testbench
