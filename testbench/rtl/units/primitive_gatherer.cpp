// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "rtl_model/refit/primitive_gatherer.h"

#include "testbench/rtl/counting_bits.h"
#include "testbench/rtl/in_out_bench.h"
#include "testbench/rtl/line_channels.h"
#include "testbench/rtl/line_memory.h"
#include "vectors/generate/gather_steps.h"

namespace cbvh::testbench {

namespace {

using vectors::GatherEvent;
using vectors::GatherStep;

bool run_steps(std::span<const GatherStep> steps, const RunOptions& options, std::uint64_t number,
               Responses& responses) {
  rtl::Channel<rtl::ReadCommand> array_channel;
  rtl::Channel<rtl::IdEntry> id_channel;
  rtl::Channel<rtl::Primitive> primitives;
  rtl::Channel<rtl::LeafMark> marks;
  LineChannels port;
  rtl::PrimitiveGatherer<CountingBits> unit(array_channel, id_channel, port.port(), primitives, marks,
                                            {vectors::kGathererLines, 4, 8});
  auto memory = make_line_memory({port.port()}, options, number);
  std::vector<rtl::ReadCommand> arrays;
  std::vector<rtl::IdEntry> ids;
  for (const vectors::GatherInput& input : prepare(steps, memory.store)) {
    if (input.is_id) {
      ids.push_back(input.id);
    } else {
      arrays.push_back(input.array);
    }
  }
  Source<rtl::ReadCommand> array_source(array_channel, arrays, source_stalls(options, number + 1));
  Source<rtl::IdEntry> id_source(id_channel, ids, source_stalls(options, number));
  Sink<rtl::Primitive> sink(primitives, sink_stalls(options, number));
  Sink<rtl::LeafMark> mark_sink(marks, sink_stalls(options, number + 1));
  AccessMonitor accesses(port);
  rtl::Clock clock(array_source, id_source, array_channel, id_channel, unit, port, accesses, memory, primitives, marks,
                   sink, mark_sink);
  Runner runner(clock, options);
  const auto given = [&] { return std::min(sink.items.size(), mark_sink.items.size()); };
  const bool finished = runner.run_until([&] { return given() >= ids.size(); },
                                         [&] { return id_channel.pops() + given() + memory.reads; });
  runner.drain();
  for (std::size_t i = 0; i < given(); ++i) {
    const GatherEvent event{rtl::UInt<1>(0), sink.items[i], mark_sink.items[i], {}};
    responses.add(&event, vectors::kLatencyNotStated);
  }
  for (const rtl::LineRequest& access : accesses.accesses) {
    const GatherEvent event{rtl::UInt<1>(1), {}, {}, access.line};
    responses.add(&event, vectors::kLatencyNotStated);
  }
  responses.cycles += clock.cycle();
  return finished;
}

}  // namespace

UnitDriver primitive_gatherer_driver() {
  return {"primitive_gatherer", [](const vectors::VectorSet& set, const RunOptions& options) {
            Responses responses(sizeof(GatherEvent));
            for (std::size_t index = 0; index < set.size(); ++index) {
              const auto steps = typed_stimuli<GatherStep, GatherEvent>(set, set.stimulus_range(index));
              responses.end_case(!run_steps(steps, options, set.head(index).id, responses));
            }
            return responses;
          }};
}

}  // namespace cbvh::testbench
