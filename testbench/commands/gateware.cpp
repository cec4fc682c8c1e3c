// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include <memory>
#include <string>

#include "golden/tree/atomic_file.h"
#include "testbench/command_line.h"
#include "testbench/gateware/board_constants.h"
#include "testbench/gateware/constants.h"
#include "testbench/output.h"

namespace cbvh::testbench {

namespace {

struct Options {
  std::string file;
  bool board = false;
  Output output;
};

int run(const Options& options) {
  const std::string constants = options.board ? board_constants() : gateware_constants();
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
  const Command command = commands.add(
      "gateware", "Writes cbvh_constants.vh: the constants that the Verilog twins share with the C++ modules",
      [options] { return run(*options); });
  command.add_option("-o,--output", options->file, "the file; without it, stdout").type_name("FILE");
  command.add_flag(
      "--board", options->board,
      "engine/cbvh_board.vh instead: numbers of the board link, and what the frame engine knows of each unit");
  options->output.add_option(command);
}

}  // namespace cbvh::testbench
