// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/eval/space/command.h"

#include "golden/build/builder.h"
#include "golden/input_error.h"
#include "testbench/eval/findings.h"
#include "testbench/eval/space/measure.h"
#include "testbench/eval/space/tables.h"
#include "testbench/output.h"

namespace cbvh::testbench {

namespace {

struct Options {
  SpaceJob job;
  Output output;
};

int run(const Options& options) {
  if (options.job.rays == 0) throw golden::InputError("--rays", "found 0, want 1 or more");
  const SpaceMeasures measures = measure_space(options.job);
  Findings findings;
  findings.add_all(measures.trees);
  findings.add_all(measures.overlap);
  findings.tables = {space_table(measures.trees), space_rays_table(measures.trees),
                     space_overlap_table(measures.overlap)};
  return report(findings, options.output);
}

}  // namespace

void add_space_evaluation(const Command& eval, const std::shared_ptr<std::function<int()>>& chosen) {
  auto options = std::make_shared<Options>();
  options->job.scenes = {"proc:city,triangles=5000", "rotated:proc:city,triangles=5000"};
  const Command command = eval.add_subcommand(
      "space", "Trees that subdivide space beside those of objects: size, expected cost, and what random rays cost");
  command.callback([options, chosen] { *chosen = [options] { return run(*options); }; });
  command.add_option("scenes", options->job.scenes, "as eval takes them").type_name("SCENE...").capture_default_str();
  command
      .add_option("--builder", options->job.builders,
                  "NAME[,key=value...] in place of the paper's trees; again for more of them")
      .allow_extra_args(false)
      .type_name("BUILDER");
  command.add_option("--overlap", options->job.penalties, "penalties C_O of the overlap curve")
      .delimiter(',')
      .allow_extra_args(false)
      .type_name("C,...")
      .capture_default_str();
  command.add_option("--rays", options->job.rays, "of each kind").capture_default_str();
  command.add_option("-j,--jobs,--threads", options->job.threads, "threads that trace; 0: one a core")
      .capture_default_str();
  command.footer("Builders:\n" + golden::builder_help());
  options->output.add_option(command);
  options->output.add_csv_option(command);
}

}  // namespace cbvh::testbench
