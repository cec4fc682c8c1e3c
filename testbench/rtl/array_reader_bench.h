// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "testbench/rtl/in_out_bench.h"
#include "testbench/rtl/line_channels.h"
#include "testbench/rtl/line_memory.h"

namespace cbvh::testbench {

/// Units that read arrays, each case through a reader of its own. Latencies count from when it took the first command.
template <class Reader, class Item>
Responses run_array_reader(const vectors::VectorSet& set, const RunOptions& options) {
  using Step = vectors::MemoryStep<rtl::ReadCommand>;
  Responses responses(sizeof(Item));
  for (std::size_t index = 0; index < set.size(); ++index) {
    const std::uint64_t number = set.head(index).id;
    rtl::Channel<rtl::ReadCommand> command_channel;
    rtl::Channel<Item> items;
    LineChannels port;
    Reader reader(command_channel, port.port(), items);
    auto memory = make_line_memory({port.port()}, options, number);
    const auto commands = prepare(typed_stimuli<Step, Item>(set, set.stimulus_range(index)), memory.store);
    AcceptanceMonitor<rtl::ReadCommand> acceptance(command_channel);
    Source<rtl::ReadCommand> source(command_channel, commands, source_stalls(options, number));
    Sink<Item> sink(items, sink_stalls(options, number));
    rtl::Clock clock(source, command_channel, acceptance, reader, port, memory, items, sink);
    Runner runner(clock, options);
    const std::size_t wanted = set.response_range(index).size;
    const bool finished =
        runner.run_until([&] { return acceptance.count() == commands.size() && sink.items.size() >= wanted; },
                         [&] { return acceptance.count() + sink.items.size() + memory.reads; });
    runner.drain();
    for (std::size_t i = 0; i < sink.items.size(); ++i) {
      responses.add(&sink.items[i], to_latency(acceptance.first(), sink.cycles[i]));
    }
    responses.end_case(!finished);
    responses.cycles += clock.cycle();
  }
  return responses;
}

}  // namespace cbvh::testbench
