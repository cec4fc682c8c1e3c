// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "testbench/lockstep/episode.h"

/// The Verilog bench of a twin, what it reads, and what it should write.
namespace cbvh::testbench {

/// A module lockstep_bench with the twin and a skid buffer for each of its channels. It reads "drive.txt" and writes
/// "trace.txt" in the folder +folder names. `parameters` is Verilog: "#(.N(6))".
std::string lockstep_bench(const std::string& twin, const std::string& parameters,
                           const std::vector<ChannelLog>& channels);

/// A line a clock: whether it is of reset, for each channel what its outer end does (1: push, or ready to pop), and
/// what is pushed. The first clock is of reset.
std::string drive_text(const Episode& episode);

/// A line a clock but that of reset: for each channel ready, valid, push and pop in one word, the datum at its head,
/// and what the unit pushes; - for none.
std::string expected_trace(const Episode& episode);

/// The name and the words of each signal of a line in a trace, in the order of the line.
struct TraceSignal {
  std::string name;
  std::string value;
};
std::vector<TraceSignal> trace_signals(const std::string& line, const std::vector<ChannelLog>& channels);

}  // namespace cbvh::testbench
