// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include <memory>

#include "golden/build/builder.h"
#include "golden/scene/load.h"
#include "golden/tree/tree_file.h"
#include "testbench/build_report.h"
#include "testbench/command_line.h"
#include "testbench/option_values.h"
#include "testbench/output.h"

namespace cbvh::testbench {

namespace {

struct Options {
  std::string scene;
  std::string builder = "lbvh";
  std::string code = "modulo";
  std::string scale_rule = "equation2";
  std::string min_scale = "auto";
  std::string collector = "full";
  std::string streaming = "rtl";
  int treelet = 1;
  int bits = 6;
  std::string file;
  Output output;
};

int run(const Options& options) {
  BuildJob job;
  job.builder = options.builder;
  job.stream.code =
      choice("--code", options.code, {"modulo", "relative"}) == 0 ? golden::Code::modulo : golden::Code::relative;
  job.stream.rules.scale_rule = choice("--scale-rule", options.scale_rule, {"equation2", "figure5"}) == 0
                                    ? golden::ScaleRule::equation2
                                    : golden::ScaleRule::figure5;
  job.stream.collector =
      choice("--collector", options.collector, {"full", "lazy"}) == 0 ? Collector::full : Collector::lazy;
  job.golden_streaming = choice("--streaming", options.streaming, {"rtl", "golden"}) == 1;
  check_range("--treelet", options.treelet, 1, 8);
  check_range("--bits", options.bits, 2, 8);
  job.stream.treelet = options.treelet;
  job.stream.rules.bits = options.bits;
  job.min_scale = parse_min_scale("--min-scale", options.min_scale);
  const BuildResult result = build_and_compare(golden::load_scene(options.scene), job);
  if (!options.file.empty()) golden::write_tree(options.file, result.streamed);
  Json json = {{"scene", options.scene},
               {"builder", options.builder},
               {"code", options.code},
               {"scale_rule", options.scale_rule},
               {"collector", options.collector}};
  json.update(result.json);
  options.output.text(to_text(options.scene, json));
  options.output.json(json);
  return result.pass ? kPass : kMismatch;
}

}  // namespace

void add_build_command(CommandLine& commands) {
  auto options = std::make_shared<Options>();
  const Command command = commands.add(
      "build", "Builds a scene's quantized tree as the hardware streams it, and compares it with the top-down one",
      [options] { return run(*options); });
  command.add_option("scene", options->scene, "a .glb, .gltf, .obj or .ply file, or proc:NAME[,key=value...]")
      .required()
      .type_name("SCENE");
  command.add_option("--builder", options->builder, "NAME[,key=value...], see below").capture_default_str();
  command.add_option("--code", options->code, "modulo or relative").capture_default_str();
  command.add_option("--treelet", options->treelet, "D, levels of a treelet, 1..8").capture_default_str();
  command.add_option("--bits", options->bits, "N, bits a coordinate, 2..8").capture_default_str();
  command.add_option("--scale-rule", options->scale_rule, "equation2, or figure5 to compare with the paper's tables")
      .capture_default_str();
  command.add_option("--min-scale", options->min_scale, "e_min: auto, or an exponent -149..127").capture_default_str();
  command.add_option("--collector", options->collector, "the treelet collector: full (the paper's) or lazy")
      .capture_default_str();
  command.add_option("--streaming", options->streaming, "who streams: rtl, or golden where the hardware refuses")
      .capture_default_str();
  command.add_option("-o,--output", options->file, "write the tree").type_name("FILE");
  command.footer("Builders:\n" + golden::builder_help() + "\nProcedural scenes:\n" + golden::procedural_scene_help());
  options->output.add_option(command);
}

}  // namespace cbvh::testbench
