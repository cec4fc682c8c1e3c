// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <memory>

#include "golden/build/builder.h"
#include "golden/build/two_level/top_level.h"
#include "golden/input_error.h"
#include "golden/scene/load.h"
#include "golden/scene/two_level/two_level_scenes.h"
#include "golden/tree/atomic_file.h"
#include "testbench/command_line.h"
#include "testbench/option_values.h"
#include "testbench/output.h"
#include "testbench/trace/colours.h"
#include "testbench/trace/hits/hits_report.h"
#include "testbench/trace/hits/one_ray.h"
#include "testbench/trace/intervals/check_intervals.h"
#include "testbench/trace/picture_report.h"

namespace cbvh::testbench {

namespace {

struct Options {
  TraceTrees trees;
  HitsJob hits;
  std::string code = "modulo";
  std::string compression = "streaming";
  std::string rays = "primary";
  std::string image = "shaded";
  std::string tree = "compressed";
  std::string compare;
  std::string ray;
  bool check = false;
  bool intervals = false;
  std::string file;
  Output output;
};

template <class Names>
std::size_t choice_of(const std::string& option, const std::string& found, const Names& names) {
  return choice(option, found, {names.begin(), names.end()});
}

TraceTrees trees_of(const Options& options) {
  TraceTrees trees = options.trees;
  trees.code =
      choice("--code", options.code, {"modulo", "relative"}) == 0 ? golden::Code::modulo : golden::Code::relative;
  trees.compression = static_cast<Compression>(choice_of("--compression", options.compression, kCompressions));
  check_range("--bits", trees.bits, 2, 8);
  return trees;
}

int draw_picture(const Options& options, const TraceTrees& trees, const PictureJob& job) {
  const auto kind = static_cast<ImageKind>(choice_of("--image", options.image, kImageKinds));
  const std::size_t shown = choice("--tree", options.tree, {"float", "compressed"});
  const TracedScenes scenes(trees, options.check);
  Progress progress("trace", std::uint64_t{job.height} * scenes.trees.size());
  const TracedPicture picture = trace_trees(scenes.trees, scenes.first().box(), job, shown, progress);
  if (!options.file.empty()) golden::write_file_atomically(options.file, encode_png(draw(picture, kind)));
  const Json json = to_json(scenes, job, picture);
  options.output.text(to_text(json));
  options.output.json(json);
  return json.at("pass").get<bool>() ? kPass : kMismatch;
}

int compare_with_embree(const Options& options, const TraceTrees& trees, const HitsJob& job) {
  choice("--compare", options.compare, {"embree"});
  const golden::Mesh mesh = golden::load_scene(trees.scene);
  const std::vector<HitsResult> results = compare_hits(mesh, build_and_compress(mesh, trees), job);
  const HitsSummary summary = summary_of(mesh.name, results);
  options.output.text(summary.text);
  options.output.json(summary.json);
  return summary.pass ? kPass : kMismatch;
}

int check_unit(const Options& options, const TraceTrees& trees, const PictureJob& job) {
  const golden::Mesh mesh = golden::load_scene(trees.scene);
  const IntervalsResult result = check_intervals(mesh, build_and_compress(mesh, trees).compressed, job);
  const Table table = intervals_table(result);
  std::string text = to_markdown(table);
  for (const std::string& failure : result.failures) text += fmt::format("FAILED: {}\n", failure);
  options.output.text(text);
  options.output.json({{"checks", result.box_tests + result.rays},
                       {"failures", result.failures},
                       {"tables", {{table.key, to_json(table)}}}});
  return result.failures.empty() && result.box_tests > 0 ? kPass : kMismatch;
}

int run(const Options& options) {
  const TraceTrees trees = trees_of(options);
  HitsJob job = options.hits;
  job.picture.rays = static_cast<golden::RayKind>(choice_of("--rays", options.rays, kRayKinds));
  check_picture_job(job.picture);
  if (!options.ray.empty()) {
    const OneRay one = trace_one_ray(parse_ray("--ray", options.ray), trees);
    options.output.text(one.text);
    options.output.json(one.json);
    return one.pass ? kPass : kMismatch;
  }
  if (!options.compare.empty()) return compare_with_embree(options, trees, job);
  if (options.intervals) return check_unit(options, trees, job.picture);
  return draw_picture(options, trees, job.picture);
}

void add_tree_options(const Command& command, Options& options) {
  command.add_option("--builder", options.trees.builder, "NAME[,key=value...], see below").capture_default_str();
  command.add_option("--top", options.trees.top, "of a scene of instances: NAME[,key=value...], see below")
      .capture_default_str();
  command.add_option("--bits", options.trees.bits, "N, bits a coordinate, 2..8").capture_default_str();
  command.add_option("--code", options.code, "modulo or relative").capture_default_str();
  command
      .add_option("--compression", options.compression,
                  "how the compressed tree is made: streaming (by the RTL), top-down, or refitted (by the RTL)")
      .capture_default_str();
}

void add_picture_options(const Command& command, Options& options) {
  PictureJob& picture = options.hits.picture;
  command.add_option("-o,--output", options.file, "write the picture, a PNG").type_name("FILE");
  command.add_option("--image", options.image, fmt::format("what the picture shows: {}", fmt::join(kImageKinds, ", ")))
      .capture_default_str();
  command.add_option("--tree", options.tree, "whose tests it shows: float or compressed").capture_default_str();
  command.add_option("--rays", options.rays, fmt::format("of a pixel: {}", fmt::join(kRayKinds, ", ")))
      .capture_default_str();
  command.add_option("--samples", picture.samples, "secondary rays, or paths, of a pixel").capture_default_str();
  command.add_option("--width", picture.width, "pixels").capture_default_str();
  command.add_option("--height", picture.height, "pixels").capture_default_str();
  command
      .add_option("--camera", picture.camera,
                  "around, inside, or EX,EY,EZ:TX,TY,TZ[:H]: eye, target, half the height at distance 1")
      .capture_default_str();
  command.add_flag("--check", options.check, "trace the trees of all compressions, and compare all pictures");
  command.add_option("--threads", picture.threads, "0: one a core").capture_default_str();
}

void add_compare_options(const Command& command, Options& options) {
  command.add_option("--compare", options.compare,
                     "embree: no picture, but the nearest hit of every ray against Embree's");
  for (std::size_t i = 0; i < kRaySetNames.size(); ++i) {
    command
        .add_option(fmt::format("--{}", kRaySetNames[i]), options.hits.rays[i],
                    "so many of such rays, beside those of the picture")
        .capture_default_str();
  }
  command.add_option("--seed", options.hits.seed, "of those rays").capture_default_str();
  command.add_flag("--intervals", options.intervals,
                   "no picture, but the traversal unit's interval of every box test of its rays against the exact one");
  command.add_option("--ray", options.ray, "no picture, but this ray's hit and tests, through every tree there is")
      .type_name("OX,OY,OZ,DX,DY,DZ[,TMIN,TMAX]");
}

}  // namespace

void add_trace_command(CommandLine& commands) {
  auto options = std::make_shared<Options>();
  const Command command = commands.add(
      "trace",
      "A picture of a scene through its float and its compressed tree, what it costs, and whether both see the same",
      [options] { return run(*options); });
  command.add_option("scene", options->trees.scene, "as build takes it, or of instances: KIND[,key=value...]:SCENE")
      .required()
      .type_name("SCENE");
  add_picture_options(command, *options);
  add_tree_options(command, *options);
  add_compare_options(command, *options);
  command.footer("Builders:\n" + golden::builder_help() + "\nTop levels:\n" + golden::top_level_help() +
                 "\nScenes of instances:\n" + golden::two_level_help() + "\nProcedural scenes:\n" +
                 golden::procedural_scene_help());
  options->output.add_option(command);
}

}  // namespace cbvh::testbench
