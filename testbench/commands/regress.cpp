// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/regression/regress.h"

#include <fmt/format.h>

#include <memory>

#include "golden/tree/atomic_file.h"
#include "testbench/board/connection.h"
#include "testbench/command_line.h"
#include "testbench/output.h"
#include "testbench/report/junit.h"
#include "testbench/report/print.h"

namespace cbvh::testbench {

namespace {

struct Options {
  RegressionOptions regression;
  std::string shard;
  std::string junit;
  Output output;
};

int run(const Options& options) {
  RegressionOptions regression = options.regression;
  if (!options.shard.empty()) regression.shard = parse_shard(options.shard);
  const Report report = regress(regression);
  options.output.text(to_string(report));
  options.output.json(to_json(report));
  if (!options.junit.empty()) golden::write_file_atomically(options.junit, to_junit(report));
  return judge(report).pass() ? kPass : kMismatch;
}

}  // namespace

void add_regress_command(CommandLine& commands) {
  auto options = std::make_shared<Options>();
  RegressionOptions& regression = options->regression;
  const Command command =
      commands.add("regress", "Runs every unit's vectors and whole scenes; closes with 'N passed, M failed'",
                   [options] { return run(*options); });
  command.add_option("--suite", regression.suite, "smoke or full").capture_default_str().type_name("SUITE");
  command.add_option("--unit", regression.units, "only these units").type_name("UNIT...");
  command.add_option("--scene", regression.scenes, "these scenes instead of the suite's").type_name("SCENE...");
  command.add_option("--backend", regression.backends, "these backends instead of rtl").type_name("NAME...");
  command.add_option("--stalls", regression.stalls, "only these stalls: none, source, sink, both").type_name("MODE...");
  command.add_option("--shuffle", regression.shuffle, "evaluate modules in a random order, from this seed")
      .type_name("SEED");
  command
      .add_option("--shard", options->shard, "i/n: only this share of the cases, 0 <= i < n; cbvh merge adds them up")
      .type_name("I/N");
  command.add_option("--threads", regression.threads, "threads; 0: one a core").capture_default_str();
  command.add_option("--seed", regression.seed, "seed of generated cases and stalls").capture_default_str();
  command.add_option("--set", regression.set, "only sets of this name").type_name("NAME");
  command.add_option("--only", regression.only, "only the case of this id").type_name("ID");
  command.add_option("--junit", options->junit, "also write JUnit XML").type_name("FILE");
  add_board_options(command);
  options->output.add_option(command);
}

}  // namespace cbvh::testbench
