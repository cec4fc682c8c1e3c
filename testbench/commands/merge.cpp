// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/report/merge.h"

#include <memory>

#include "golden/tree/atomic_file.h"
#include "testbench/command_line.h"
#include "testbench/output.h"
#include "testbench/report/junit.h"
#include "testbench/report/print.h"

namespace cbvh::testbench {

namespace {

struct Options {
  std::vector<std::string> reports;
  std::string junit;
  Output output;
};

int run(const Options& options) {
  std::vector<NamedReport> parts;
  for (const std::string& path : options.reports) parts.push_back({path, report_from_json(read_text_file(path), path)});
  const Report whole = merge(parts);
  options.output.text(to_string(whole));
  options.output.json(to_json(whole));
  if (!options.junit.empty()) golden::write_file_atomically(options.junit, to_junit(whole));
  return judge(whole).pass() ? kPass : kMismatch;
}

}  // namespace

void add_merge_command(CommandLine& commands) {
  auto options = std::make_shared<Options>();
  const Command command = commands.add("merge", "Adds up the JSON reports of the shards of one regression",
                                       [options] { return run(*options); });
  command.add_option("reports", options->reports, "JSON reports of all shards").required().type_name("FILE...");
  command.add_option("--junit", options->junit, "also write JUnit XML").type_name("FILE");
  options->output.add_option(command);
}

}  // namespace cbvh::testbench
