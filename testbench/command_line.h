// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "testbench/command.h"
#include "testbench/exit_code.h"

namespace CLI {
class App;
}

namespace cbvh::testbench {

/// The command line while it is being put together: subcommands add themselves to it, and the one that was asked for
/// runs.
class CommandLine {
 public:
  explicit CommandLine(CLI::App& app) : app_(app) {}

  /// A new subcommand. `run` is called after all of its options are parsed and returns the exit code; it may throw
  /// InputError and Unavailable.
  Command add(const std::string& name, const std::string& description, std::function<int()> run);

  int run_chosen() const { return chosen_(); }

 private:
  CLI::App& app_;
  std::function<int()> chosen_;
};

/// Adds one subcommand. commands/x.cpp defines add_x_command and needs no entry anywhere.
using AddCommand = void(CommandLine&);
std::vector<AddCommand*> all_commands();

/// All of main(): parses, runs one command, and turns every error into one line on stderr, `cbvh: place: what`, and an
/// exit code.
int run_command_line(int argc, const char* const* argv);

}  // namespace cbvh::testbench
