// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <memory>
#include <optional>

#include "testbench/board/connection.h"
#include "testbench/command_line.h"
#include "testbench/output.h"
#include "testbench/regression/check_set.h"
#include "testbench/regression/regress.h"
#include "testbench/report/print.h"
#include "vectors/format/format.h"
#include "vectors/registry.h"

namespace cbvh::testbench {

namespace {

struct Options {
  std::string file;
  std::string backend = "rtl";
  std::string stalls = "none";
  std::optional<std::uint64_t> shuffle;
  std::optional<std::uint64_t> only;
  bool dump_case = false;
  unsigned threads = 0;
  Output output;
};

std::string rerun_line(const Options& options, const std::string& backend, std::uint64_t id) {
  std::string line = fmt::format("cbvh check '{}' --backend {} --stalls {} --only {} --dump-case", options.file,
                                 backend, options.stalls, id);
  if (options.shuffle) line += fmt::format(" --shuffle {}", *options.shuffle);
  return line;
}

/// The cases to run, cut into sets of a size that threads can share.
std::vector<std::shared_ptr<vectors::VectorSet>> read_pieces(const Options& options) {
  constexpr std::size_t kCasesPerPiece = 10000;
  const auto reader = vectors::open_set(options.file);
  std::vector<std::shared_ptr<vectors::VectorSet>> pieces;
  for (;;) {
    std::shared_ptr<vectors::VectorSet> batch = reader->empty_set();
    if (!reader->next(*batch, kCasesPerPiece)) break;
    if (!options.only) {
      pieces.push_back(batch);
    } else if (const std::size_t index = batch->find(*options.only); index < batch->size()) {
      std::shared_ptr<vectors::VectorSet> one = reader->empty_set();
      one->copy_case(*batch, index);
      pieces.push_back(one);
    }
  }
  if (pieces.empty())
    throw golden::InputError(options.file, fmt::format("no case has id {}", options.only.value_or(0)));
  return pieces;
}

/// A plan of one set, whose ids are the pieces' numbers.
PlannedSet plan_backend(const Options& options, const std::string& backend,
                        const std::vector<std::shared_ptr<vectors::VectorSet>>& pieces) {
  PlannedSet plan;
  const auto runs = make_backend(backend);
  require_unit(*runs, pieces[0]->unit());
  require_parameters(*runs, *pieces[0]);
  if (runs->stalls()) plan.run.stalls = parse_stalls(options.stalls);
  plan.run.stall_seed = pieces[0]->seed();
  if (runs->shuffles()) plan.run.shuffle = options.shuffle;
  plan.report.unit = pieces[0]->unit().name;
  plan.report.set = options.file;
  plan.report.backend = backend;
  plan.report.mode = mode_name(plan.run);
  plan.report.total_cases = pieces.size();
  plan.work = [&options, backend, &pieces, run = plan.run](const std::vector<std::uint64_t>& ids, SetReport& report) {
    for (const std::uint64_t piece : ids) {
      check_set(
          *pieces[piece], *make_backend(backend), run,
          [&](std::uint64_t id) { return rerun_line(options, backend, id); }, report);
    }
  };
  return plan;
}

int run(const Options& options) {
  parse_stalls(options.stalls);
  if (options.stalls != "none" && options.backend == "board") {
    throw golden::InputError("--stalls", "backend board cannot be made to stall, want none");
  }
  const auto backend = make_backend(options.backend);
  if (options.shuffle && !backend->shuffles()) {
    throw golden::InputError("--shuffle", fmt::format("backend {} has no order of evaluation", options.backend));
  }
  const auto pieces = read_pieces(options);
  if (options.dump_case && options.only) options.output.text(vectors::serialize(*pieces[0], vectors::Format::text));
  Report report;
  report.command = "check";
  report.seed = pieces[0]->seed();
  std::vector<PlannedSet> plan = {plan_backend(options, "golden", pieces)};
  if (options.backend != "golden") plan.push_back(plan_backend(options, options.backend, pieces));
  RegressionOptions how;
  how.threads = options.threads;
  run_plan(plan, how, report);
  for (SetReport& set : report.sets) set.total_cases = set.cases;
  options.output.text(to_string(report));
  options.output.json(to_json(report));
  return judge(report).pass() ? kPass : kMismatch;
}

}  // namespace

void add_check_command(CommandLine& commands) {
  auto options = std::make_shared<Options>();
  const Command command = commands.add(
      "check",
      "Runs a vector file: its responses against the golden, then a backend against its responses, bit for bit",
      [options] { return run(*options); });
  command.add_option("file", options->file, "a vector file of any format").required().type_name("FILE");
  command.add_option("--backend", options->backend, "who runs it").capture_default_str().type_name("NAME");
  command.add_option("--stalls", options->stalls, "which ends hold back: none, source, sink, both")
      .capture_default_str()
      .type_name("MODE");
  command.add_option("--shuffle", options->shuffle, "evaluate modules in a random order, from this seed")
      .type_name("SEED");
  command.add_option("--only", options->only, "only the case of this id").type_name("ID");
  command.add_flag("--dump-case", options->dump_case, "print the case of --only as a vector file");
  command.add_option("--threads", options->threads, "threads; 0: one a core").capture_default_str();
  add_board_options(command);
  options->output.add_option(command);
}

}  // namespace cbvh::testbench
