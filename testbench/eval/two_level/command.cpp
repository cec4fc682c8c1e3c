// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/eval/two_level/command.h"

#include <fmt/format.h>

#include "golden/build/two_level/top_level.h"
#include "golden/input_error.h"
#include "golden/scene/two_level/two_level_scenes.h"
#include "testbench/eval/two_level/measure.h"
#include "testbench/eval/two_level/table.h"
#include "testbench/exit_code.h"
#include "testbench/output.h"

namespace cbvh::testbench {

namespace {

struct Options {
  TwoLevelJob job{
      .scenes = {"deal,objects=16,chunk=1000:proc:spheres", "deal,objects=84,chunk=20:proc:city",
                 "deal,objects=64,chunk=50:proc:terrain,triangles=50000", "bounce:proc:hairball,triangles=5000"},
      .tops = {"plain", "agglomerative", "rebraid", "rebraid,width=4", "rebraid,open=leaves", "rebraid,order=cost"}};
  Output output;
};

int run(const Options& options) {
  if (options.job.repeats == 0) throw golden::InputError("--repeats", "found 0, want 1 or more");
  const std::vector<TopLevelMeasure> measures = measure_two_level(options.job);
  std::uint64_t checks = 0;
  std::vector<std::string> failures;
  for (const TopLevelMeasure& measure : measures) {
    checks += measure.checks;
    failures.insert(failures.end(), measure.failures.begin(), measure.failures.end());
  }
  const Table table = two_level_table(measures);
  std::string text = to_markdown(table);
  for (const std::string& failure : failures) text += fmt::format("FAILED: {}\n", failure);
  text += fmt::format("{} checks passed, {} failed\n", checks - failures.size(), failures.size());
  options.output.text(text);
  options.output.csv(kCsvHeading + to_csv(table));
  options.output.json({{"checks", checks}, {"failures", failures}, {"tables", {{table.key, to_json(table)}}}});
  return failures.empty() && checks > 0 ? kPass : kMismatch;
}

}  // namespace

void add_two_level_evaluation(const Command& eval, const std::shared_ptr<std::function<int()>>& chosen) {
  auto options = std::make_shared<Options>();
  const Command command = eval.add_subcommand(
      "two-level", "Top levels over instances beside each other: quality, size, time, and what compressing them costs");
  command.callback([options, chosen] { *chosen = [options] { return run(*options); }; });
  command.add_option("scenes", options->job.scenes, "each KIND[,key=value...]:SCENE, SCENE as eval takes it")
      .type_name("SCENE...")
      .capture_default_str();
  command.add_option("--top", options->job.tops, "NAME[,key=value...]; again for more of them")
      .allow_extra_args(false)
      .type_name("TOP")
      .capture_default_str();
  command.add_option("--objects", options->job.objects, "builder of the objects' trees, and of the single tree")
      .type_name("BUILDER")
      .capture_default_str();
  command.add_option("--repeats", options->job.repeats, "build so often, the fastest counts").capture_default_str();
  command.add_option("--most-single", options->job.most_single, "no single tree of more triangles")
      .capture_default_str();
  command.footer("Scenes:\n" + golden::two_level_help() + "Top levels:\n" + golden::top_level_help());
  options->output.add_option(command);
  options->output.add_csv_option(command);
}

}  // namespace cbvh::testbench
