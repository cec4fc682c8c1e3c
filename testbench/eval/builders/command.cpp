// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/eval/builders/command.h"

#include "golden/build/builder.h"
#include "golden/input_error.h"
#include "testbench/eval/builders/measure.h"
#include "testbench/eval/builders/tables.h"
#include "testbench/eval/findings.h"
#include "testbench/output.h"

namespace cbvh::testbench {

namespace {

struct Options {
  BuildersJob job{{"proc:cloth", "proc:terrain,triangles=20000", "proc:city,triangles=20000",
                   "proc:hairball,triangles=20000", "proc:spheres,triangles=20000"},
                  {},
                  1};
  Output output;
};

std::vector<std::string> all_builders() {
  std::vector<std::string> names;
  for (const golden::BuilderKind& kind : golden::builder_kinds()) names.push_back(kind.name);
  return names;
}

int run(const Options& options) {
  BuildersJob job = options.job;
  if (job.builders.empty()) job.builders = all_builders();
  if (job.repeats == 0) throw golden::InputError("--repeats", "found 0, want 1 or more");
  const std::vector<BuilderMeasure> measures = measure_builders(job);
  Findings findings;
  findings.add_all(measures);
  findings.tables = {builder_trees_table(measures), builder_compression_table(measures)};
  return report(findings, options.output);
}

}  // namespace

void add_builders_evaluation(const Command& eval, const std::shared_ptr<std::function<int()>>& chosen) {
  auto options = std::make_shared<Options>();
  const Command command = eval.add_subcommand(
      "builders", "Every builder's trees beside each other: quality, size, time, and what compressing them costs");
  command.callback([options, chosen] { *chosen = [options] { return run(*options); }; });
  command.add_option("scenes", options->job.scenes, "as eval takes them").type_name("SCENE...").capture_default_str();
  command
      .add_option("--builder", options->job.builders,
                  "NAME[,key=value...], as build takes it; again for more of them; all, if none is named")
      .allow_extra_args(false)
      .type_name("BUILDER");
  command.add_option("--repeats", options->job.repeats, "build so often, the fastest counts").capture_default_str();
  command.footer("Builders:\n" + golden::builder_help());
  options->output.add_option(command);
  options->output.add_csv_option(command);
}

}  // namespace cbvh::testbench
