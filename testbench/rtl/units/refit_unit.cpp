// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "rtl_model/refit/refit_unit.h"

#include "testbench/rtl/counting_bits.h"
#include "testbench/rtl/tree_events.h"
#include "vectors/generate/tree_steps.h"

namespace cbvh::testbench {

namespace {

template <int N>
Responses run(const vectors::VectorSet& set, const RunOptions& options) {
  rtl::RefitConfig config;
  config.addresses = {rtl::LineAddress(vectors::kRefitPairs), rtl::LineAddress(vectors::kRefitIds),
                      rtl::LineAddress(vectors::kRefitPrimitives)};
  config.treelet_levels = set.parameters().treelet;
  config.outstanding = 2;
  config.gatherer = {4, 2, 4};
  config.written_lines = 2;
  return run_trees<N, rtl::RefitCommand, rtl::RefitReport>(
      set, vectors::kRefitPairs, [&](auto steps, std::uint64_t number, Responses& responses, auto&& tell) {
        rtl::Channel<rtl::RefitCommand> command_channel;
        rtl::Channel<rtl::RefitReport> reports;
        LineChannels tree, ids, primitives, nodes;
        rtl::RefitUnit<CountingBits, N> unit(command_channel, reports,
                                             {tree.port(), ids.port(), primitives.port(), nodes.port()}, config);
        auto memory = make_line_memory({tree.port(), ids.port(), primitives.port(), nodes.port()}, options, number);
        const auto commands = prepare(steps, memory.store);
        Source<rtl::RefitCommand> source(command_channel, commands, source_stalls(options, number));
        Sink<rtl::RefitReport> sink(reports, sink_stalls(options, number));
        rtl::Clock clock(source, command_channel, unit, tree, ids, primitives, nodes, memory, reports, sink);
        Runner runner(clock, options);
        const bool finished = runner.run_until([&] { return !sink.items.empty(); },
                                               [&] { return memory.reads + memory.writes + sink.items.size(); });
        runner.drain();
        for (const rtl::RefitReport& report : sink.items) {
          tell(memory.store, commands[0].pairs.value(), report, report.tree.status != rtl::StatusBits());
        }
        responses.cycles += clock.cycle();
        return finished;
      });
}

}  // namespace

UnitDriver refit_unit_driver() {
  return {"refit_unit", [](const vectors::VectorSet& set, const RunOptions& options) {
            return with_packed_bits(set.parameters().bits,
                                    [&]<int N>(std::integral_constant<int, N>) { return run<N>(set, options); });
          }};
}

}  // namespace cbvh::testbench
