// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "rtl_model/memory/node_writer.h"

#include <bit>

#include "testbench/rtl/counting_bits.h"
#include "testbench/rtl/in_out_bench.h"
#include "testbench/rtl/line_channels.h"
#include "testbench/rtl/line_memory.h"
#include "vectors/generate/node_writer_steps.h"

namespace cbvh::testbench {

namespace {

/// Gives requests and reports in their order, one a cycle.
template <int N>
class StepSource {
 public:
  using Step = vectors::NodeWriterStep<N>;

  StepSource(rtl::Channel<rtl::MemoryRequest<N>>& requests, rtl::Channel<rtl::StreamReport>& reports,
             std::span<const Step> steps, rtl::StallPattern stalls)
      : requests_(requests), reports_(reports), steps_(steps), stalls_(stalls) {}

  void tick() {
    if (stalls_.stalls() || next_ == steps_.size()) return;
    const Step& step = steps_[next_];
    if (step.ends && reports_.can_push()) {
      reports_.push(step.report);
      ++next_;
    } else if (!step.ends && requests_.can_push()) {
      requests_.push(step.request);
      ++next_;
    }
  }
  void commit(rtl::CommitKey) {}

 private:
  rtl::Channel<rtl::MemoryRequest<N>>& requests_;
  rtl::Channel<rtl::StreamReport>& reports_;
  std::span<const Step> steps_;
  rtl::StallPattern stalls_;
  std::size_t next_ = 0;
};

template <int N>
bool run_steps(std::span<const vectors::NodeWriterStep<N>> steps, const RunOptions& options, std::uint64_t number,
               Responses& responses) {
  using Event = vectors::NodeWriterEvent<N>;
  std::vector<std::size_t> slots;  // that reads want
  std::size_t trees = 0;
  for (const auto& step : steps) {
    trees += step.ends.value();
    if (step.ends || step.request.write) continue;
    slots.push_back(static_cast<std::size_t>(std::countr_zero(step.request.mask.value())) % rtl::kPairsPerLine);
  }
  rtl::Channel<rtl::MemoryRequest<N>> requests;
  rtl::Channel<rtl::MemoryLine<N>> lines;
  rtl::Channel<rtl::StreamReport> reports;
  rtl::Channel<rtl::StreamReport> finished;
  LineChannels port;
  rtl::NodeWriter<CountingBits, N> unit(requests, lines, reports, port.port(), finished,
                                        {rtl::LineAddress(vectors::kWriterFirstLine), vectors::kWriterLines});
  auto memory = make_line_memory({port.port()}, options, number);
  StepSource<N> source(requests, reports, steps, source_stalls(options, number));
  Sink<rtl::MemoryLine<N>> answers(lines, sink_stalls(options, number));
  Sink<rtl::StreamReport> ends(finished, sink_stalls(options, number + 1));
  AccessMonitor accesses(port);
  rtl::Clock clock(source, requests, reports, unit, port, accesses, memory, lines, finished, answers, ends);
  Runner runner(clock, options);
  const bool done = runner.run_until([&] { return ends.items.size() >= trees && answers.items.size() >= slots.size(); },
                                     [&] {
                                       return requests.pops() + reports.pops() + memory.reads + memory.writes +
                                              answers.items.size() + ends.items.size();
                                     });
  runner.drain();
  const auto add = [&](typename Event::Kind kind, Event event) {
    event.kind = rtl::UInt<2>(static_cast<std::uint64_t>(kind));
    responses.add(&event, vectors::kLatencyNotStated);
  };
  for (std::size_t i = 0; i < std::min(answers.items.size(), slots.size()); ++i) {
    add(Event::Kind::answer, {{}, answers.items[i].pairs[slots[i]], {}, {}});
  }
  for (const rtl::LineRequest& access : accesses.accesses) add(Event::Kind::access, {{}, {}, access, {}});
  for (const rtl::StreamReport& report : ends.items) add(Event::Kind::report, {{}, {}, {}, report});
  responses.cycles += clock.cycle();
  return done;
}

}  // namespace

UnitDriver node_writer_driver() {
  return {"node_writer", [](const vectors::VectorSet& set, const RunOptions& options) {
            return with_packed_bits(set.parameters().bits, [&]<int N>(std::integral_constant<int, N>) {
              using Step = vectors::NodeWriterStep<N>;
              using Event = vectors::NodeWriterEvent<N>;
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
