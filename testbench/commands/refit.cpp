// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <memory>

#include "golden/build/lbvh.h"
#include "golden/quantize/scale.h"
#include "golden/scene/load.h"
#include "golden/tree/tree_file.h"
#include "golden/update/top_down.h"
#include "testbench/command_line.h"
#include "testbench/output.h"
#include "testbench/scene_of_frame.h"
#include "testbench/sim/sim_options.h"

namespace cbvh::testbench {

namespace {

struct Options {
  std::string tree;
  MovingScene scene;
  std::string file;
  SimOptions sim;
  Output output;
};

/// The tree of a file, or of a scene as the golden builds it.
golden::CompressedTree tree_to_refit(const Options& options, const SimConfig& config) {
  if (options.tree.ends_with(".cbvh")) return golden::read_tree(options.tree);
  const golden::FloatTree floats = golden::build_lbvh(golden::load_scene(options.tree));
  const golden::GridRules rules{static_cast<int>(config.bits), checked_min_scale(config, floats), config.scale_rule};
  return golden::compress_top_down(floats, rules, config.code);
}

std::string frames_text(const Json& frames) {
  std::string text =
      fmt::format("{:<6} {:>10} {:>9} {:>12} {:>11} {:>13} {:>8} {:>9} {:>16} {}\n", "frame", "triangles", "pairs",
                  "cycles", "over bound", "bytes", "ratio", "by model", "digest", "identical");
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const Json& frame = frames[i];
    text += fmt::format("{:<6} {:>10} {:>9} {:>12} {:>11.3f} {:>13} {:>8.3f} {:>9.3f} {:>16} {}\n", i,
                        frame["triangles"].get<std::uint64_t>(), frame["pairs"].get<std::uint64_t>(),
                        frame["cycles"].get<std::uint64_t>(), frame["over_bandwidth_bound"].get<double>(),
                        frame["counted_bytes"].get<std::uint64_t>(), frame["traffic_ratio"].get<double>(),
                        frame["model_traffic_ratio"].get<double>(), frame["digest"].get<std::string>(),
                        frame["identical"].dump());
  }
  return text + fmt::format("ratio: bytes over those of refitting floats and compressing them top-down afterwards\n");
}

int run(const Options& options) {
  const SimRequest request = options.sim.request();
  if (options.sim.lists_config(request.config, options.output)) return kPass;
  if (options.tree.empty() || options.scene.scene.empty()) throw golden::InputError("refit", "want a TREE and a SCENE");
  check_moving_scene(options.scene);
  golden::CompressedTree tree = tree_to_refit(options, request.config);
  Json frames = Json::array();
  bool pass = true;
  std::string text;
  for (unsigned frame = 0; frame < options.scene.frames; ++frame) {
    SimResult result = simulate_refit(tree, scene_of_frame(options.scene, frame), request);
    pass = pass && result.pass();
    frames.push_back(to_json(result));
    if (options.scene.frames == 1 || !result.pass()) text += to_text(result);
    tree = std::move(*result.tree);
  }
  if (!options.file.empty() && pass) golden::write_tree(options.file, tree);
  if (options.scene.frames > 1) text += frames_text(frames);
  options.output.text(text);
  options.output.json({{"tree", options.tree}, {"scene", options.scene.scene}, {"frames", frames}, {"pass", pass}});
  return pass ? kPass : kMismatch;
}

}  // namespace

void add_refit_command(CommandLine& commands) {
  auto options = std::make_shared<Options>();
  const Command command =
      commands.add("refit", "Refits a tree in the simulated memory around moved triangles, cycle by cycle and in place",
                   [options] { return run(*options); });
  command.add_option("tree", options->tree, "a .cbvh file, or the scene to build it from").type_name("TREE");
  command
      .add_option("scene", options->scene.scene, "the moved triangles; {time} in it goes from 0 to 1 over the frames")
      .type_name("SCENE");
  command.add_option("--frames", options->scene.frames, "refit so many times in turn, each the tree of the one before")
      .capture_default_str();
  command
      .add_option("--twist", options->scene.twist, "turn the scene around its y axis, up to so many turns at its top")
      .capture_default_str();
  command.add_option("-o,--output", options->file, "write the last tree").type_name("FILE");
  options->sim.add_to(command);
  options->output.add_option(command);
}

}  // namespace cbvh::testbench
