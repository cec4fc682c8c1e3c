// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "rtl_model/lbvh/primitive_reader.h"

#include "testbench/rtl/in_out_bench.h"
#include "testbench/rtl/line_memory.h"
#include "vectors/lbvh_payloads.h"

namespace cbvh::testbench {

namespace {

/// One episode: memory holds the lines, and the reader starts.
bool run_lines(std::span<const vectors::PrimitiveLine> lines, const RunOptions& options, std::uint64_t number,
               Responses& responses) {
  if (lines.empty()) return true;
  const rtl::LineAddress first_line = lines[0].first_line;
  const std::uint64_t count = lines[0].primitives.value();
  rtl::Channel<rtl::LineRequest> requests;
  rtl::Channel<rtl::LineData> answers;
  rtl::Channel<rtl::Primitive> primitives;
  rtl::PrimitiveReader unit(requests, answers, primitives, first_line, count);
  auto memory = make_line_memory({{&requests, &answers}}, options, number);
  for (std::size_t i = 0; i < lines.size() * rtl::kWordsPerLine; ++i) {
    const std::uint64_t word = lines[i / rtl::kWordsPerLine].words[i % rtl::kWordsPerLine].value();
    memory.store.poke(first_line.value() * rtl::kWordsPerLine + i, static_cast<std::uint32_t>(word));
  }
  AcceptanceMonitor<rtl::LineRequest> acceptance(requests);
  Sink<rtl::Primitive> sink(primitives, sink_stalls(options, number));
  rtl::Clock clock(unit, requests, acceptance, memory, answers, primitives, sink);
  Runner runner(clock, options);
  const bool finished =
      runner.run_until([&] { return sink.items.size() >= count; }, [&] { return sink.items.size() + memory.reads; });
  runner.drain();
  for (std::size_t i = 0; i < sink.items.size(); ++i) {
    responses.add(&sink.items[i], to_latency(acceptance.first(), sink.cycles[i]));
  }
  responses.cycles += clock.cycle();
  return finished;
}

}  // namespace

UnitDriver primitive_reader_driver() {
  return {"primitive_reader", [](const vectors::VectorSet& set, const RunOptions& options) {
            Responses responses(sizeof(rtl::Primitive));
            for (std::size_t index = 0; index < set.size(); ++index) {
              const auto lines = typed_stimuli<vectors::PrimitiveLine, rtl::Primitive>(set, set.stimulus_range(index));
              responses.end_case(!run_lines(lines, options, set.head(index).id, responses));
            }
            return responses;
          }};
}

}  // namespace cbvh::testbench
