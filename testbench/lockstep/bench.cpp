// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/lockstep/bench.h"

#include <fmt/format.h>

#include <sstream>

namespace cbvh::testbench {

namespace {

/// What one channel of the bench needs: NAME_in_ and NAME_out_ are the two sides of its skid buffer.
struct ChannelText {
  std::string declarations, ports, drives, writes;
};

ChannelText channel_text(const ChannelLog& channel, std::size_t index) {
  const bool to_unit = channel.flow == Flow::to_unit;
  const std::string& name = channel.name;
  ChannelText text;
  const auto declare = [&](const char* kind, const std::string& what, const char* side, const char* signal) {
    text.declarations += fmt::format("  {} {}{}_{}_{};\n", kind, what, name, side, signal);
  };
  const std::string range = fmt::format("[{}:0] ", channel.width - 1);
  declare(to_unit ? "reg" : "wire", "", "in", "valid");
  declare("wire", "", "in", "ready");
  declare(to_unit ? "reg" : "wire", range, "in", "data");
  declare("wire", "", "out", "valid");
  declare(to_unit ? "wire" : "reg", "", "out", "ready");
  declare("wire", range, "out", "data");
  text.declarations += fmt::format(
      "  skid_buffer #({0}) {1}_channel (clk, reset, {1}_in_valid, {1}_in_ready, {1}_in_data,"
      " {1}_out_valid, {1}_out_ready, {1}_out_data);\n",
      channel.width, name);
  for (const char* signal : {"valid", "ready", "data"}) {
    text.ports += fmt::format(", .{0}_{1}({0}_{2}_{1})", name, signal, to_unit ? "out" : "in");
  }
  if (to_unit) {
    text.drives = fmt::format(
        "      {0}_in_valid = drive[{1}];\n      if (drive[{1}]) code = $fscanf(drives, \"%h\", {0}_in_data);\n", name,
        index);
  } else {
    text.drives = fmt::format("      {}_out_ready = drive[{}];\n", name, index);
  }
  text.writes = fmt::format(
      "        $fwrite(trace, \"%b%b%b%b\", {0}_in_ready, {0}_out_valid, {0}_in_valid & {0}_in_ready,"
      " {0}_out_valid & {0}_out_ready);\n"
      "        if ({0}_out_valid === 1'b1) $fwrite(trace, \" %h \", {0}_out_data); else $fwrite(trace, \" - \");\n",
      name);
  if (!to_unit) {
    text.writes += fmt::format(
        "        if ({0}_in_valid === 1'b1 && {0}_in_ready) $fwrite(trace, \"%h \", {0}_in_data);"
        " else $fwrite(trace, \"- \");\n",
        name);
  }
  return text;
}

/// The item that stands at an index, or - where `there` is false.
const std::string& item(const ChannelLog& log, bool there, std::size_t index) {
  static const std::string none = "-";
  return there ? log.items.at(index) : none;
}

/// How many items of a channel were pushed and popped before a clock.
struct Counts {
  std::size_t pushes = 0;
  std::size_t pops = 0;
};

/// Calls visit(channel, bits, counts) for each channel of each clock, and end_clock() behind each clock.
template <class Visit, class EndClock>
void visit_clocks(const Episode& episode, Visit&& visit, EndClock&& end_clock) {
  std::vector<Counts> counts(episode.channels.size());
  for (std::size_t clock = 0; clock < episode.channels[0].clocks.size(); ++clock) {
    for (std::size_t i = 0; i < counts.size(); ++i) {
      const unsigned bits = episode.channels[i].clocks[clock];
      visit(episode.channels[i], bits, counts[i]);
      counts[i].pushes += (bits & ChannelLog::push) != 0;
      counts[i].pops += (bits & ChannelLog::pop) != 0;
    }
    end_clock();
  }
}

}  // namespace

std::string lockstep_bench(const std::string& twin, const std::string& parameters,
                           const std::vector<ChannelLog>& channels) {
  ChannelText all;
  for (std::size_t i = 0; i < channels.size(); ++i) {
    const ChannelText one = channel_text(channels[i], i);
    all.declarations += one.declarations;
    all.ports += one.ports;
    all.drives += one.drives;
    all.writes += one.writes;
  }
  return fmt::format(R"(module lockstep_bench;
  reg clk, reset;
{0}  {1} {2} unit (.clk(clk), .reset(reset){3});
  reg [{4}:0] drive;  // of reset, then of each channel from the last to the first
  reg [8*1024:1] folder;
  integer drives, trace, code;
  initial begin
    clk = 1'b0;
    code = $value$plusargs("folder=%s", folder);
    drives = $fopen({{folder, "/drive.txt"}}, "r");
    trace = $fopen({{folder, "/trace.txt"}}, "w");
    while ($fscanf(drives, "%b", drive) == 1) begin
      reset = drive[{4}];
{5}      #1;
      if (!reset) begin
{6}        $fwrite(trace, "\n");
      end
      clk = 1'b1;
      #1 clk = 1'b0;
    end
    $fwrite(trace, "end\n");
    $fclose(trace);
    $finish;
  end
endmodule
)",
                     all.declarations, twin, parameters, all.ports, channels.size(), all.drives, all.writes);
}

std::string drive_text(const Episode& episode) {
  std::string text = "1" + std::string(episode.channels.size(), '0') + "\n";
  std::string drives;
  std::string pushed;
  visit_clocks(
      episode,
      [&](const ChannelLog& log, unsigned bits, const Counts& counts) {
        const bool moves = (bits & (log.flow == Flow::to_unit ? ChannelLog::push : ChannelLog::pop)) != 0;
        drives.insert(drives.begin(), moves ? '1' : '0');
        if (moves && log.flow == Flow::to_unit) pushed += " " + log.items.at(counts.pushes);
      },
      [&] {
        text += "0" + drives + pushed + "\n";
        drives.clear();
        pushed.clear();
      });
  return text;
}

std::string expected_trace(const Episode& episode) {
  std::string text;
  visit_clocks(
      episode,
      [&](const ChannelLog& log, unsigned bits, const Counts& counts) {
        for (const unsigned bit : {ChannelLog::ready, ChannelLog::valid, ChannelLog::push, ChannelLog::pop}) {
          text.push_back((bits & bit) != 0 ? '1' : '0');
        }
        text += " " + item(log, (bits & ChannelLog::valid) != 0, counts.pops) + " ";
        if (log.flow == Flow::from_unit) text += item(log, (bits & ChannelLog::push) != 0, counts.pushes) + " ";
      },
      [&] { text += "\n"; });
  return text;
}

std::vector<TraceSignal> trace_signals(const std::string& line, const std::vector<ChannelLog>& channels) {
  std::istringstream words(line);
  std::vector<TraceSignal> signals;
  const auto next = [&] {
    std::string word = "nothing";
    words >> word;
    return word;
  };
  for (const ChannelLog& channel : channels) {
    const std::string state = next();
    const char* const names[] = {"ready", "valid", "push", "pop"};
    for (std::size_t i = 0; i < std::size(names); ++i) {
      signals.push_back({channel.name + "." + names[i], i < state.size() ? state.substr(i, 1) : state});
    }
    signals.push_back({channel.name + ".data", next()});
    if (channel.flow == Flow::from_unit) signals.push_back({channel.name + ".pushed", next()});
  }
  return signals;
}

}  // namespace cbvh::testbench
