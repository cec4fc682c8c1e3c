// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <span>
#include <string>

#include "testbench/lockstep/twin.h"
#include "testbench/rtl/in_out_bench.h"
#include "vectors/registry.h"

/// Twins with one channel in and one out, and a unit of the same name in the registry.
namespace cbvh::testbench {

inline std::string verilog_bits(const vectors::Parameters& parameters) {
  return fmt::format("#(.N({}))", parameters.bits);
}
inline std::string verilog_bits_and_levels(const vectors::Parameters& parameters) {
  return fmt::format("#(.N({}), .D({}))", parameters.bits, parameters.treelet);
}
inline std::string verilog_nothing(const vectors::Parameters&) { return {}; }

/// make(in, out) gives the module.
template <class In, class Out, class Make>
Episode record_in_out(Make&& make, std::span<const In> items, const RunOptions& options, std::uint64_t number,
                      const std::string& in_name, const std::string& out_name) {
  rtl::Channel<In> in;
  rtl::Channel<Out> out;
  auto unit = make(in, out);
  Source<In> source(in, items, source_stalls(options, number));
  Sink<Out> sink(out, sink_stalls(options, number));
  Probe<In> in_probe(in, in_name, Flow::to_unit);
  Probe<Out> out_probe(out, out_name, Flow::from_unit);
  rtl::Clock clock(source, in, unit, out, sink, in_probe, out_probe);
  return record_episode(clock, in_probe, out_probe);
}

/// Generated cases of a unit: without state all in one episode, else one episode each.
template <class In, class Out, class Make>
std::vector<Episode> record_cases(Make&& make, const std::string& unit, const vectors::Parameters& parameters,
                                  std::uint64_t cases, const RunOptions& options, std::uint64_t seed,
                                  const std::string& in_name = "jobs", const std::string& out_name = "results") {
  const auto set = vectors::generate_set(unit, parameters, cases, seed);
  if (!set->unit().stateful) {
    const auto items = typed_stimuli<In, Out>(*set, {0, set->stimulus_count()});
    return {record_in_out<In, Out>(make, items, options, 0, in_name, out_name)};
  }
  std::vector<Episode> episodes;
  for (std::size_t i = 0; i < set->size(); ++i) {
    const auto items = typed_stimuli<In, Out>(*set, set->stimulus_range(i));
    episodes.push_back(record_in_out<In, Out>(make, items, options, set->head(i).id, in_name, out_name));
  }
  return episodes;
}

}  // namespace cbvh::testbench
