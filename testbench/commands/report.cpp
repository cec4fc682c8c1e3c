// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "golden/input_error.h"
#include "golden/tree/atomic_file.h"
#include "testbench/command_line.h"
#include "testbench/output.h"
#include "testbench/report_page/document.h"

namespace cbvh::testbench {

namespace {

struct Options {
  std::vector<std::string> files;
  std::string page;
};

void refuse_overwriting(const Options& options) {
  for (const std::string& file : options.files) {
    std::error_code none;
    if (std::filesystem::equivalent(file, options.page, none))
      throw golden::InputError("--output",
                               fmt::format("found {}, which is also read, want another file", options.page));
  }
}

int run(const Options& options) {
  refuse_overwriting(options);
  Contents contents;
  for (const std::string& file : options.files) recognise(file, read_text_file(file), contents);
  const Tally tally = tally_of(contents);
  golden::write_file_atomically(options.page, report_page(contents));
  fmt::print("{}: {} results, {} pictures; {} checks passed, {} failed, {} skipped\n", options.page,
             contents.results.size(), contents.pictures.size(), tally.passed, tally.failed, tally.skipped);
  return outcome(tally) == Outcome::passed ? kPass : kMismatch;
}

}  // namespace

void add_report_command(CommandLine& commands) {
  auto options = std::make_shared<Options>();
  const Command command = commands.add("report", "One self-contained HTML page of what other commands wrote",
                                       [options] { return run(*options); });
  command.add_option("files", options->files, "JSON of --json, and PNG pictures, in any order")
      .required()
      .type_name("FILE...");
  command.add_option("-o,--output", options->page, "the page").required().type_name("FILE");
}

}  // namespace cbvh::testbench
