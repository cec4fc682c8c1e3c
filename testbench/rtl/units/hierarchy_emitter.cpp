// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "rtl_model/lbvh/hierarchy_emitter.h"

#include "testbench/rtl/counting_bits.h"
#include "testbench/rtl/in_out_bench.h"
#include "vectors/lbvh_payloads.h"

namespace cbvh::testbench {

namespace {

using vectors::EmitEvent;

/// What went through one of the three outputs, as events.
template <class T>
class Output {
 public:
  Output(const Sink<T>& sink, EmitEvent::Kind kind, T EmitEvent::*field, std::uint64_t start)
      : sink_(sink), kind_(kind), field_(field), start_(start) {}

  bool empty() const { return next_ == sink_.items.size(); }
  const T& add(Responses& responses) {
    EmitEvent event;
    event.kind = rtl::UInt<2>(static_cast<std::uint64_t>(kind_));
    event.*field_ = sink_.items[next_];
    responses.add(&event, to_latency(start_, sink_.cycles[next_]));
    return sink_.items[next_++];
  }

 private:
  const Sink<T>& sink_;
  EmitEvent::Kind kind_;
  T EmitEvent::*field_;
  std::uint64_t start_;
  std::size_t next_ = 0;
};

/// `wanted` responses end it, but not before every scene's report: any of the outputs may be held back longest.
bool run_steps(std::span<const vectors::EmitStep> steps, std::size_t wanted, const RunOptions& options,
               std::uint64_t number, Responses& responses) {
  std::vector<rtl::SortItem> records;
  std::size_t scenes = 0;
  for (const vectors::EmitStep& step : steps) {
    records.push_back(step.item);
    scenes += step.item.last.value();
  }
  rtl::Channel<rtl::SortItem> items;
  rtl::Channel<rtl::StreamJob> jobs;
  rtl::Channel<rtl::IdEntry> ids;
  rtl::Channel<rtl::EmitReport> reports;
  rtl::HierarchyEmitter<CountingBits> unit(items, jobs, ids, reports, steps.front().registers);
  AcceptanceMonitor<rtl::SortItem> acceptance(items);
  Source<rtl::SortItem> source(items, records, source_stalls(options, number));
  Sink<rtl::StreamJob> job_sink(jobs, sink_stalls(options, number));
  Sink<rtl::IdEntry> id_sink(ids, sink_stalls(options, number + 1));
  Sink<rtl::EmitReport> report_sink(reports, sink_stalls(options, number + 2));
  rtl::Clock clock(source, items, acceptance, unit, jobs, ids, reports, job_sink, id_sink, report_sink);
  Runner runner(clock, options);
  const auto received = [&] { return job_sink.items.size() + id_sink.items.size() + report_sink.items.size(); };
  const bool finished = runner.run_until([&] { return report_sink.items.size() >= scenes && received() >= wanted; },
                                         [&] { return items.pops() + jobs.pops() + ids.pops() + reports.pops(); });
  runner.drain();
  using Kind = EmitEvent::Kind;
  Output<rtl::StreamJob> pairs(job_sink, Kind::pair, &EmitEvent::job, acceptance.first());
  Output<rtl::IdEntry> entries(id_sink, Kind::id, &EmitEvent::id, acceptance.first());
  Output<rtl::EmitReport> ends(report_sink, Kind::report, &EmitEvent::report, acceptance.first());
  for (const rtl::EmitReport& report : report_sink.items) {
    for (std::uint64_t i = 0; i < report.pairs.value() && !pairs.empty(); ++i) pairs.add(responses);
    while (!entries.empty() && !entries.add(responses).last) {
    }
    ends.add(responses);
  }
  while (!pairs.empty()) pairs.add(responses);
  while (!entries.empty()) entries.add(responses);
  responses.cycles += clock.cycle();
  return finished;
}

}  // namespace

UnitDriver hierarchy_emitter_driver() {
  return {
      "hierarchy_emitter", [](const vectors::VectorSet& set, const RunOptions& options) {
        Responses responses(sizeof(EmitEvent));
        for (std::size_t index = 0; index < set.size(); ++index) {
          const auto steps = typed_stimuli<vectors::EmitStep, EmitEvent>(set, set.stimulus_range(index));
          responses.end_case(!run_steps(steps, set.response_range(index).size, options, set.head(index).id, responses));
        }
        return responses;
      }};
}

}  // namespace cbvh::testbench
