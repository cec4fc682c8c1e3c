// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "testbench/rtl/in_out_bench.h"
#include "testbench/rtl/line_memory.h"
#include "vectors/lbvh_payloads.h"

namespace cbvh::testbench {

/// One episode of a unit that writes a stream to memory: lines when memory takes them, reports when the sink does.
/// make(items, requests, answers, reports) gives it.
template <class Item, class Make>
bool run_writer(Make&& make, std::span<const Item> stimuli, std::size_t wanted_reports, const RunOptions& options,
                std::uint64_t number, Responses& responses) {
  rtl::Channel<Item> items;
  rtl::Channel<rtl::LineRequest> requests;
  rtl::Channel<rtl::LineData> answers;
  rtl::Channel<rtl::WriteReport> reports;
  auto unit = make(items, requests, answers, reports);
  auto memory = make_line_memory({{&requests, &answers}}, options, number);
  AcceptanceMonitor<Item> acceptance(items);
  AcceptanceMonitor<rtl::LineRequest> taken(requests);
  LineWriteMonitor lines(requests);
  Source<Item> source(items, stimuli, source_stalls(options, number));
  Sink<rtl::WriteReport> sink(reports, sink_stalls(options, number));
  rtl::Clock clock(source, items, acceptance, unit, requests, taken, lines, memory, answers, reports, sink);
  Runner runner(clock, options);
  const bool finished = runner.run_until([&] { return sink.items.size() >= wanted_reports; },
                                         [&] { return items.pops() + sink.items.size() + memory.writes; });
  runner.drain();
  // A report comes behind the lines that it acknowledges, and those of the next stream behind it.
  std::size_t line = 0;
  const auto add_line = [&] {
    const vectors::WriteEvent event{{}, lines.writes[line], {}};
    responses.add(&event, to_latency(acceptance.first(), taken[line++]));
  };
  for (std::size_t i = 0; i < sink.items.size(); ++i) {
    for (bool last = false; line < lines.writes.size() && !last;) {
      last = bool(lines.writes[line].acknowledge);
      add_line();
    }
    const vectors::WriteEvent event{rtl::UInt<1>(1), {}, sink.items[i]};
    responses.add(&event, to_latency(acceptance.first(), sink.cycles[i]));
  }
  while (line < lines.writes.size()) add_line();
  responses.cycles += clock.cycle();
  return finished;
}

}  // namespace cbvh::testbench
