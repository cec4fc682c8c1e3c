// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/eval/rays/command.h"

#include "golden/build/builder.h"
#include "testbench/eval/findings.h"
#include "testbench/eval/rays/measure.h"
#include "testbench/eval/rays/tables.h"
#include "testbench/option_values.h"
#include "testbench/output.h"

namespace cbvh::testbench {

namespace {

struct Options {
  RaysJob job{.scenes = {"proc:cloth", "proc:terrain,triangles=20000", "proc:city,triangles=20000",
                         "proc:hairball,triangles=20000", "proc:spheres,triangles=20000"}};
  std::string code = "modulo";
  Output output;
};

int run(const Options& options) {
  RaysJob job = options.job;
  job.code =
      choice("--code", options.code, {"modulo", "relative"}) == 0 ? golden::Code::modulo : golden::Code::relative;
  const RaysMeasurement result = measure_rays(job);
  Findings findings;
  findings.add(result);
  findings.tables = {ray_tests_average_table(result.measures), ray_tests_table(result.measures)};
  return report(findings, options.output);
}

}  // namespace

void add_rays_evaluation(const Command& eval, const std::shared_ptr<std::function<int()>>& chosen) {
  auto options = std::make_shared<Options>();
  const Command command =
      eval.add_subcommand("rays", "Box and triangle tests through compressed trees over those through the float tree");
  command.callback([options, chosen] { *chosen = [options] { return run(*options); }; });
  command.add_option("scenes", options->job.scenes, "as eval takes them").type_name("SCENE...").capture_default_str();
  command.add_option("--builder", options->job.builder, "NAME[,key=value...], as build takes it").capture_default_str();
  command.add_option("--code", options->code, "modulo or relative").capture_default_str();
  command.add_option("--camera", options->job.picture.camera, "as trace takes it").capture_default_str();
  command.add_option("--width", options->job.picture.width, "of a picture, pixels").capture_default_str();
  command.add_option("--height", options->job.picture.height, "of a picture, pixels").capture_default_str();
  command.add_option("--samples", options->job.picture.samples, "secondary rays, or paths, of a pixel")
      .capture_default_str();
  command.add_option("--threads", options->job.picture.threads, "0: one a core").capture_default_str();
  command.footer("Builders:\n" + golden::builder_help());
  options->output.add_option(command);
  options->output.add_csv_option(command);
}

}  // namespace cbvh::testbench
