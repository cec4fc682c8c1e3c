// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "rtl_model/compress/top_down_compressor.h"

#include "testbench/rtl/counting_bits.h"
#include "testbench/rtl/tree_events.h"
#include "vectors/generate/tree_steps.h"

namespace cbvh::testbench {

namespace {

template <int N>
Responses run(const vectors::VectorSet& set, const RunOptions& options) {
  const rtl::TopDownAddresses addresses{rtl::LineAddress(vectors::kTopDownFloatPairs),
                                        rtl::LineAddress(vectors::kTopDownPairs)};
  return run_trees<N, rtl::TopDownCommand, rtl::StreamReport>(
      set, vectors::kTopDownPairs, [&](auto steps, std::uint64_t number, Responses& responses, auto&& tell) {
        rtl::Channel<rtl::TopDownCommand> command_channel;
        rtl::Channel<rtl::StreamReport> reports;
        LineChannels reads, writes;
        rtl::TopDownCompressor<CountingBits, N> unit(command_channel, reads.port(), writes.port(), reports, addresses);
        auto memory = make_line_memory({reads.port(), writes.port()}, options, number);
        const auto commands = prepare(steps, memory.store);
        Source<rtl::TopDownCommand> source(command_channel, commands, source_stalls(options, number));
        Sink<rtl::StreamReport> sink(reports, sink_stalls(options, number));
        rtl::Clock clock(source, command_channel, unit, reads, writes, memory, reports, sink);
        Runner runner(clock, options);
        const bool finished = runner.run_until([&] { return !sink.items.empty(); },
                                               [&] { return memory.reads + memory.writes + sink.items.size(); });
        runner.drain();
        for (const rtl::StreamReport& report : sink.items) {
          tell(memory.store, commands[0].pairs.value(), report, report.status != rtl::StatusBits());
        }
        responses.cycles += clock.cycle();
        return finished;
      });
}

}  // namespace

UnitDriver top_down_compressor_driver() {
  return {"top_down_compressor", [](const vectors::VectorSet& set, const RunOptions& options) {
            return with_packed_bits(set.parameters().bits,
                                    [&]<int N>(std::integral_constant<int, N>) { return run<N>(set, options); });
          }};
}

}  // namespace cbvh::testbench
