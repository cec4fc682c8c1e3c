// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// Plugs an emulated board into a mocked USB bus and runs a command that sees it.
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <csignal>
#include <cstring>

#include "fpga/emulator/gateware/gateware_core.h"
#include "fpga/emulator/model/model_core.h"
#include "fpga/emulator/usb/board.h"
#include "fpga/emulator/usb/preload.h"
#include "golden/input_error.h"
#include "testbench/exit_code.h"
#include "testbench/unavailable.h"

extern char** environ;

namespace {

using namespace cbvh;

constexpr int kSignalBase = 128;
constexpr int kBufferBits =
    15;  ///< of simulated gateware, which has room for the largest episodes of the committed sets

struct Options {
  std::string transport = "bulk";
  std::string core = "model";
  std::string unit;
  std::optional<int> bits;
  std::optional<int> treelet;
  std::vector<std::string> faults;
  std::uint64_t seed = 1;
  bool verbose = false;
};

std::unique_ptr<emulator::Core> make_core(const Options& options) {
  if (options.core == "model") {
    return std::make_unique<emulator::ModelCore>(
        emulator::CoreOptions{.unit = options.unit, .bits = options.bits, .treelet = options.treelet});
  }
  if (options.core == "gateware") {
    emulator::SimulationOptions simulation{.buffer_bits = kBufferBits, .result_bits = kBufferBits};
    if (!options.unit.empty()) simulation.unit = options.unit;
    simulation.bits = options.bits.value_or(simulation.bits);
    simulation.treelet = options.treelet.value_or(simulation.treelet);
    return std::make_unique<emulator::GatewareCore>(simulation);
  }
  throw golden::InputError("--core", fmt::format("found '{}', want model, gateware", options.core));
}

/// The command's exit code, 128 and more after a signal. Throws InputError when it cannot be started.
int run_command(char** command) {
  pid_t child = 0;
  const int error = posix_spawnp(&child, command[0], nullptr, nullptr, command, environ);
  if (error != 0) throw golden::InputError(command[0], fmt::format("cannot run it: {}", std::strerror(error)));
  int status = 0;
  while (waitpid(child, &status, 0) < 0) {
  }
  return WIFSIGNALED(status) ? kSignalBase + WTERMSIG(status) : WEXITSTATUS(status);
}

int emulate(const Options& options, char** command) {
  std::vector<emulator::Fault> faults;
  for (const std::string& fault : options.faults) faults.push_back(emulator::parse_fault(fault));
  const emulator::Transport transport = emulator::parse_transport(options.transport);
  const std::unique_ptr<emulator::Core> core = make_core(options);
  emulator::Link link(*core, std::move(faults), options.seed);
  emulator::UsbSystem system;
  int code = 0;
  unsigned plugged = 0;
  {
    emulator::UsbBoard board(system, transport, link);
    code = run_command(command);
    plugged = board.plugged();
  }
  if (options.verbose) {
    std::string text;
    for (const auto& [kind, count] : link.happened()) text += fmt::format(", {} {}", to_string(kind), count);
    fmt::print(stderr, "cbvh_emulator: plugged in {} times{}\n", plugged, text);
  }
  return code;
}

}  // namespace

int main(int argc, char** argv) {
  emulator::preload_umockdev(argv);
  Options options;
  CLI::App app(
      "Plugs an emulated board into a mocked USB bus, runs the command behind -- , which sees it, and passes its exit "
      "code on.",
      "cbvh_emulator");
  app.add_option("--transport", options.transport, "bulk (1209:b5c0), ftdi-uart (FT2232H) or ftdi-fifo (FT232H)");
  app.add_option("--core", options.core,
                 "what is inside: model, the C++ modules, or gateware, the Verilog of one unit");
  app.add_option("--unit", options.unit, "the only unit it has");
  app.add_option("--bits", options.bits, "the only N it has");
  app.add_option("--treelet", options.treelet, "the only D it has");
  app.add_option(
      "--fault", options.faults,
      fmt::format("KIND[:RATE], what goes wrong with transfers: {}", fmt::join(emulator::kFaultNames, ", ")));
  app.add_option("--seed", options.seed, "of the faults");
  app.add_flag("--verbose", options.verbose, "say on stderr what went wrong on purpose");
  char** const end = argv + argc;
  char** const separator = std::find_if(argv, end, [](const char* text) { return std::strcmp(text, "--") == 0; });
  try {
    app.parse(static_cast<int>(separator - argv), argv);
    if (separator == end || separator + 1 == end) throw golden::InputError("COMMAND", "found none, want it behind --");
    std::signal(SIGINT, SIG_IGN);  // the command gets it, too
    return emulate(options, separator + 1);
  } catch (const CLI::CallForHelp&) {
    fmt::print("{}", app.help());
    return testbench::kPass;
  } catch (const CLI::ParseError& error) {
    fmt::print(stderr, "cbvh_emulator: {}\n", error.what());
  } catch (const testbench::Unavailable& error) {
    fmt::print(stderr, "cbvh_emulator: {}\n", error.what());
    return testbench::kSkipped;
  } catch (const std::exception& error) {
    fmt::print(stderr, "cbvh_emulator: {}\n", error.what());
  }
  return testbench::kBadInput;
}
