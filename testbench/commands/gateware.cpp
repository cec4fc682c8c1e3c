// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "golden/tree/atomic_file.h"
#include "testbench/command_line.h"
#include "testbench/gateware/constants.h"
#include "testbench/output.h"

namespace cbvh::testbench {

namespace {

struct Options {
  std::string file;
  Output output;
};

int run(const Options& options) {
  const std::string constants = gateware_constants();
  if (options.file.empty()) {
    options.output.text(constants);
  } else {
    golden::write_file_atomically(options.file, constants);
  }
  options.output.json({{"constants", constants}});
  return kPass;
}

}  // namespace

void add_gateware_command(CommandLine& commands) {
  auto options = std::make_shared<Options>();
  CLI::App& command = commands.add(
      "gateware", "Writes cbvh_constants.vh: the constants that the Verilog twins share with the C++ modules",
      [options] { return run(*options); });
  command.add_option("-o,--output", options->file, "the file; without it, stdout")->type_name("FILE");
  options->output.add_option(command);
}

}  // namespace cbvh::testbench
