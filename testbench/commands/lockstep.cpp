// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "golden/input_error.h"
#include "golden/threads/parallel_for.h"
#include "testbench/command_line.h"
#include "testbench/gateware/simulator.h"
#include "testbench/lockstep/compare.h"
#include "testbench/output.h"
#include "testbench/unavailable.h"

namespace cbvh::testbench {

namespace {

struct Options {
  std::vector<std::string> twins;
  std::vector<std::string> stalls;
  std::uint64_t cycles = 100000;
  std::uint64_t seed = 1;
  unsigned threads = 0;
  Output output;
};

std::vector<LockstepTwin> chosen_twins(const std::vector<std::string>& wanted) {
  std::vector<LockstepTwin> all = all_lockstep_twins();
  if (wanted.empty()) return all;
  std::vector<LockstepTwin> chosen;
  for (const std::string& name : wanted) {
    const auto found = std::find_if(all.begin(), all.end(), [&](const auto& twin) { return twin.name == name; });
    if (found == all.end()) {
      std::string names;
      for (const LockstepTwin& twin : all) names += fmt::format("{}{}", names.empty() ? "" : ", ", twin.name);
      throw golden::InputError("twin", fmt::format("found '{}', want {}", name, names));
    }
    chosen.push_back(*found);
  }
  return chosen;
}

Json to_json(const LockstepResult& result) {
  return {{"twin", result.twin},     {"stalls", to_string(result.stalls)},
          {"cycles", result.cycles}, {"signals", result.signals},
          {"moves", result.moves},   {"difference", result.difference}};
}

int run(const Options& options) {
  const std::vector<LockstepTwin> twins = chosen_twins(options.twins);
  std::vector<Stalls> patterns;
  for (const std::string& name : options.stalls) patterns.push_back(parse_stalls(name));
  if (const std::string reason = why_no_simulator(); !reason.empty()) throw Unavailable("lockstep: " + reason);
  std::vector<std::vector<LockstepResult>> results(twins.size());
  golden::parallel_for(twins.size(), options.threads, [&](std::size_t i) {
    results[i] = compare_lockstep(twins[i], patterns, options.cycles, options.seed);
  });
  std::string text;
  std::uint64_t passed = 0;
  std::uint64_t failed = 0;
  Json json = Json::array();
  for (const auto& of_twin : results) {
    for (const LockstepResult& result : of_twin) {
      text += fmt::format("{:<28} {:<8} {:>9} cycles {:>10} signals {:>9} moves  {}\n", result.twin,
                          to_string(result.stalls), result.cycles, result.signals, result.moves,
                          result.pass() ? "equal" : "DIFFERS");
      if (!result.difference.empty()) text += fmt::format("  {}\n", result.difference);
      ++(result.pass() ? passed : failed);
      json.push_back(to_json(result));
    }
  }
  options.output.text(text + fmt::format("{} passed, {} failed\n", passed, failed));
  options.output.json({{"results", json}, {"passed", passed}, {"failed", failed}});
  return failed == 0 && passed > 0 ? kPass : kMismatch;
}

}  // namespace

void add_lockstep_command(CommandLine& commands) {
  auto options = std::make_shared<Options>();
  options->stalls = stall_names();
  const Command command =
      commands.add("lockstep", "Verilog twins beside their C++ modules: every signal of every cycle",
                   [options] { return run(*options); });
  command.add_option("twin", options->twins, "only these twins").type_name("TWIN");
  command.add_option("--cycles", options->cycles, "at least, for each twin and each pattern of stalls")
      .capture_default_str()
      .positive()
      .type_name("C");
  command.add_option("--stalls", options->stalls, "only these patterns: none, source, sink, both").type_name("MODE");
  command.add_option("--seed", options->seed, "of jobs and stalls").capture_default_str().type_name("SEED");
  command.add_option("--threads", options->threads, "0: one a core").capture_default_str().type_name("T");
  options->output.add_option(command);
}

}  // namespace cbvh::testbench
