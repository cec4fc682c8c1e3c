// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <memory>

#include "testbench/command_line.h"
#include "testbench/output.h"
#include "vectors/capture.h"
#include "vectors/format/format.h"
#include "vectors/registry.h"

namespace cbvh::testbench {

namespace {

struct Options {
  std::string unit;
  vectors::Parameters parameters;
  std::uint64_t cases = 4096;
  std::uint64_t seed = 1;
  std::string scene;
  std::string file;
  Output output;
};

int run(const Options& options) {
  vectors::format_of_path(options.file);  // an unknown extension is found before the work
  if (options.cases == 0) throw golden::InputError("--cases", "found 0, want at least 1");
  vectors::CaptureOptions capture;
  capture.cases = options.cases;
  const auto set = options.scene.empty()
                       ? vectors::generate_set(options.unit, options.parameters, options.cases, options.seed)
                       : vectors::capture_set(options.unit, options.parameters, options.scene, capture);
  vectors::write_set(*set, options.file);
  const vectors::Counts counts = set->counts();
  options.output.text(fmt::format("{}: {} cases, {} responses, {} checks\n", options.file, counts.cases,
                                  counts.responses, counts.checks + counts.latencies));
  options.output.json({{"file", options.file},
                       {"unit", options.unit},
                       {"bits", options.parameters.bits},
                       {"treelet", options.parameters.treelet},
                       {"seed", set->seed()},
                       {"scene", options.scene},
                       {"cases", counts.cases},
                       {"responses", counts.responses},
                       {"checks", counts.checks + counts.latencies}});
  return kPass;
}

}  // namespace

void add_gen_command(CommandLine& commands) {
  auto options = std::make_shared<Options>();
  const Command command = commands.add("gen", "Generates vectors of a unit with the golden's responses",
                                       [options] { return run(*options); });
  command.add_option("--unit", options->unit, "the unit (see cbvh units)").required().type_name("UNIT");
  command.add_option("--cases", options->cases, "number of cases").capture_default_str();
  command.add_option("--seed", options->seed, "seed of the random parts").capture_default_str();
  command.add_option("--bits", options->parameters.bits, "N, bits a coordinate, 2..8").capture_default_str();
  command.add_option("--treelet", options->parameters.treelet, "D, levels of a treelet, 1..8").capture_default_str();
  command.add_option("--scene", options->scene, "capture what the unit meets in this scene instead; --cases at most")
      .type_name("SCENE");
  command.add_option("-o,--output", options->file, "the file: .vec text, .hex for $readmemh, .bin binary")
      .required()
      .type_name("FILE");
  options->output.add_option(command);
}

}  // namespace cbvh::testbench
