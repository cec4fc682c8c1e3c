// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include <memory>

#include "golden/scene/load.h"
#include "golden/tree/tree_file.h"
#include "testbench/command_line.h"
#include "testbench/output.h"
#include "testbench/sim/sim_options.h"

namespace cbvh::testbench {

namespace {

struct Options {
  std::string scene;
  std::string file;
  SimOptions sim;
  Output output;
};

int run(const Options& options) {
  const SimRequest request = options.sim.request();
  if (options.sim.lists_config(request.config, options.output)) return kPass;
  if (options.scene.empty()) throw golden::InputError("sim", "want a SCENE");
  if (!options.file.empty() && request.config.output == PipelineOutput::floats)
    throw golden::InputError("--output", "the pipeline of output=float leaves no compressed tree");
  const SimResult result = simulate_lbvh(golden::load_scene(options.scene), request);
  if (!options.file.empty() && result.identical) golden::write_tree(options.file, *result.tree);
  Json json = to_json(result);
  json["config"] = to_json(request.config);
  options.output.text(to_text(result));
  options.output.json(json);
  return result.pass() ? kPass : kMismatch;
}

}  // namespace

void add_sim_command(CommandLine& commands) {
  auto options = std::make_shared<Options>();
  const Command command = commands.add(
      "sim", "Runs the whole builder cycle by cycle: triangles in DRAM to a tree in DRAM, compared with the golden's",
      [options] { return run(*options); });
  command.add_option("scene", options->scene, "a .glb, .gltf, .obj or .ply file, or proc:NAME[,key=value...]")
      .type_name("SCENE");
  command.add_option("-o,--output", options->file, "write the tree that is in memory at the end").type_name("FILE");
  options->sim.add_to(command);
  command.footer(golden::procedural_scene_help());
  options->output.add_option(command);
}

}  // namespace cbvh::testbench
