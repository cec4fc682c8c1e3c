// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/eval/two_level/command.h"

#include <fmt/format.h>

#include "golden/build/two_level/top_level.h"
#include "golden/input_error.h"
#include "golden/scene/two_level/two_level_scenes.h"
#include "testbench/eval/findings.h"
#include "testbench/eval/two_level/frames.h"
#include "testbench/eval/two_level/measure.h"
#include "testbench/eval/two_level/table.h"
#include "testbench/output.h"

namespace cbvh::testbench {

namespace {

struct Options {
  TwoLevelJob job{
      .scenes = {"deal,objects=16,chunk=1000:proc:spheres", "deal,objects=84,chunk=20:proc:city",
                 "deal,objects=64,chunk=50:proc:terrain,triangles=50000", "bounce:proc:hairball,triangles=5000"},
      .tops = {"plain", "agglomerative", "rebraid", "rebraid,space=4,triangles=1000", "rebraid,width=4",
               "rebraid,open=leaves", "rebraid,order=cost"}};
  unsigned frames = 0;
  PictureSize picture;
  Output output;
};

int run_frames(const Options& options) {
  const std::vector<FramesMeasure> measures = measure_frames(options.job, options.frames, options.picture);
  Findings findings;
  for (const FramesMeasure& measure : measures) {
    findings.checks += measure.frames.size();
    for (const FrameMeasure& frame : measure.frames) {
      if (!frame.same_picture) {
        findings.failures.push_back(
            fmt::format("{}, {} of {} trees, frame {}: the picture is not that of the first top level", measure.scene,
                        measure.top, measure.trees, frame.frame));
      }
    }
  }
  findings.tables = {frames_table(measures), every_frame_table(measures)};
  return report(findings, options.output);
}

int run(const Options& options) {
  if (options.job.repeats == 0) throw golden::InputError("--repeats", "found 0, want 1 or more");
  if (options.frames > 0) return run_frames(options);
  const std::vector<TopLevelMeasure> measures = measure_two_level(options.job);
  Findings findings;
  findings.add_all(measures);
  findings.tables = {two_level_table(measures)};
  return report(findings, options.output);
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
  command.add_option("--frames", options->frames,
                     "build and trace every top level in so many frames, in which {time} in a scene goes from 0 to 1");
  command.add_option("--width", options->picture.width, "of a frame's picture, pixels").capture_default_str();
  command.add_option("--height", options->picture.height, "of a frame's picture, pixels").capture_default_str();
  command.add_option("--threads", options->picture.threads, "that trace a picture; builds have an option of their own")
      .capture_default_str();
  command.footer("Scenes:\n" + golden::two_level_help() + "Top levels:\n" + golden::top_level_help());
  options->output.add_option(command);
  options->output.add_csv_option(command);
}

}  // namespace cbvh::testbench
