// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/lockstep/compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <stdexcept>

#include "golden/input_error.h"
#include "testbench/gateware/process.h"
#include "testbench/gateware/simulator.h"
#include "testbench/lockstep/bench.h"
#include "testbench/output.h"

namespace cbvh::testbench {

namespace {

void write_file(const std::string& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary);
  file << text;
  file.close();
  if (!file) throw golden::InputError(path, "cannot be written");
}

/// The compiled bench of a twin with some parameters.
class BenchModel {
 public:
  BenchModel(const LockstepTwin& twin, const vectors::Parameters& parameters, const std::vector<ChannelLog>& channels) {
    write_file(path("bench.v"), lockstep_bench(std::string(twin.name), twin.verilog(parameters), channels));
    const std::string twins = twin_folder();
    const std::string log = path("compile.log");
    const int code = run_program({"iverilog", "-g2005", "-o", path("bench.vvp"), "-s", "lockstep_bench", "-y", twins,
                                  "-I", twins, path("bench.v")},
                                 log);
    if (code != 0) throw golden::InputError("iverilog", read_text_file(log));
  }

  /// The trace of all episodes.
  std::string run(const std::string& drive) const {
    write_file(path("drive.txt"), drive);
    const std::string log = path("run.log");
    const int code = run_program({"vvp", "-n", path("bench.vvp"), "+folder=" + folder_.path()}, log);
    std::string trace = read_text_file(path("trace.txt"));
    constexpr std::string_view kEnd = "end\n";
    if (code != 0 || !trace.ends_with(kEnd)) {
      throw std::runtime_error(fmt::format("vvp: exit code {}: {}", code, read_text_file(log)));
    }
    trace.resize(trace.size() - kEnd.size());
    return trace;
  }

 private:
  std::string path(const char* name) const { return fmt::format("{}/{}", folder_.path(), name); }

  TemporaryFolder folder_;
};

std::string take_line(std::string_view& text) {
  const std::size_t end = std::min(text.find('\n'), text.size());
  std::string line(text.substr(0, end));
  text.remove_prefix(std::min(end + 1, text.size()));
  return line;
}

/// The first difference of two traces, or nothing: episode, cycle, signal, both values.
std::string first_difference(const std::vector<Episode>& episodes, std::string_view module, std::string_view twin) {
  for (std::size_t episode = 0; episode < episodes.size(); ++episode) {
    const auto& channels = episodes[episode].channels;
    for (std::size_t cycle = 0; cycle < channels[0].clocks.size(); ++cycle) {
      const std::string want_line = take_line(module);
      const std::string found_line = take_line(twin);
      if (want_line == found_line) continue;
      const auto want = trace_signals(want_line, channels);
      const auto found = trace_signals(found_line, channels);
      for (std::size_t i = 0; i < want.size(); ++i) {
        if (want[i].value == found[i].value) continue;
        return fmt::format("episode {} cycle {}: {}: C++ {}, Verilog {}", episode, cycle, want[i].name, want[i].value,
                           found[i].value);
      }
    }
  }
  return module == twin ? "" : "the traces have not the same length";
}

void count(const std::vector<Episode>& episodes, LockstepResult& result) {
  for (const Episode& episode : episodes) {
    const std::uint64_t cycles = episode.channels[0].clocks.size();
    result.cycles += cycles;
    for (const ChannelLog& log : episode.channels) {
      result.signals += cycles * (log.flow == Flow::from_unit ? 6 : 5);
      for (const std::uint8_t clock : log.clocks) {
        result.moves += ((clock & ChannelLog::push) != 0) + ((clock & ChannelLog::pop) != 0);
      }
    }
  }
}

/// A batch in which a channel stands still would compare nothing of it.
void require_moves(std::string_view twin, const std::vector<Episode>& episodes) {
  for (std::size_t i = 0; i < episodes.at(0).channels.size(); ++i) {
    const bool moves = std::any_of(episodes.begin(), episodes.end(), [&](const Episode& e) {
      return std::any_of(e.channels[i].clocks.begin(), e.channels[i].clocks.end(),
                         [](std::uint8_t clock) { return (clock & ChannelLog::push) != 0; });
    });
    if (!moves) {
      throw std::runtime_error(
          fmt::format("lockstep of {}: nothing went through channel {}", twin, episodes[0].channels[i].name));
    }
  }
}

/// Adds a batch to the result; false when there was a difference.
bool compare_batch(const BenchModel& model, const std::vector<Episode>& episodes, const std::string& place,
                   LockstepResult& result) {
  std::string drive;
  std::string module;
  for (const Episode& episode : episodes) {
    drive += drive_text(episode);
    module += expected_trace(episode);
  }
  const std::string twin = model.run(drive);
  const std::string difference = first_difference(episodes, module, twin);
  if (!difference.empty()) {
    result.difference = fmt::format("{}: {}", place, difference);
    return false;
  }
  count(episodes, result);
  return true;
}

/// One value of the parameters under one pattern.
void compare_parameters(const LockstepTwin& twin, const BenchModel& model, const vectors::Parameters& parameters,
                        std::uint64_t cycles, std::uint64_t seed, LockstepResult& result) {
  RunOptions options;
  options.stalls = result.stalls;
  const std::uint64_t wanted = result.cycles + cycles;
  while (result.cycles < wanted) {
    options.stall_seed = seed;
    const auto episodes = twin.record(parameters, options, seed);
    require_moves(twin.name, episodes);
    const std::string place = fmt::format("{} bits={} treelet={} stalls={} seed={}", twin.name, parameters.bits,
                                          parameters.treelet, to_string(result.stalls), seed);
    if (!compare_batch(model, episodes, place, result)) return;
    ++seed;
  }
}

}  // namespace

std::vector<LockstepTwin> all_lockstep_twins() {
  std::vector<LockstepTwin> twins;
  for (DescribeTwin* describe : all_twin_descriptions()) twins.push_back(describe());
  return twins;
}

std::vector<LockstepResult> compare_lockstep(const LockstepTwin& twin, const std::vector<Stalls>& patterns,
                                             std::uint64_t cycles, std::uint64_t seed) {
  std::vector<LockstepResult> results;
  for (const Stalls stalls : patterns) {
    LockstepResult& result = results.emplace_back();
    result.twin = twin.name;
    result.stalls = stalls;
  }
  const std::uint64_t share = (cycles + twin.parameters.size() - 1) / twin.parameters.size();
  for (const vectors::Parameters& parameters : twin.parameters) {
    const BenchModel model(twin, parameters, twin.record(parameters, {}, seed).at(0).channels);
    for (LockstepResult& result : results) {
      if (result.difference.empty()) compare_parameters(twin, model, parameters, share, seed, result);
    }
  }
  return results;
}

}  // namespace cbvh::testbench
