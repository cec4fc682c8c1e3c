// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include <memory>

#include "golden/build/lbvh.h"
#include "golden/scene/load.h"
#include "testbench/command_line.h"
#include "testbench/option_values.h"
#include "testbench/output.h"
#include "testbench/sim/sim_options.h"
#include "testbench/sim/simulate_rays.h"

namespace cbvh::testbench {

namespace {

struct Options {
  std::string scene;
  std::string rays = "primary";
  unsigned width = 128;
  unsigned height = 128;
  unsigned slots = 16;
  SimOptions sim;
  Output output;
};

int run(const Options& options) {
  const SimRequest request = options.sim.request();
  if (options.sim.lists_config(request.config, options.output)) return kPass;
  if (options.scene.empty()) throw golden::InputError("sim-rays", "want a SCENE");
  constexpr int kMostPixels = 1 << 14;
  check_range("--width", static_cast<int>(options.width), 1, kMostPixels);
  check_range("--height", static_cast<int>(options.height), 1, kMostPixels);
  const auto kind = static_cast<SimulatedRays>(choice("--rays", options.rays, {"primary", "diffuse"}));
  const golden::Mesh mesh = golden::load_scene(options.scene);
  check_triangles(mesh.name, mesh.triangles.size(), request.config);
  const golden::FloatTree tree = golden::build_lbvh(mesh);
  const RaysResult result =
      simulate_rays(mesh, tree, image_rays(mesh, tree, kind, options.width, options.height), options.slots, request);
  Json json = to_json(result);
  json["kind"] = options.rays;
  json["slots"] = options.slots;
  json["config"] = to_json(request.config);
  options.output.text(to_text(result));
  options.output.json(json);
  return result.pass() ? kPass : kMismatch;
}

}  // namespace

void add_sim_rays_command(CommandLine& commands) {
  auto options = std::make_shared<Options>();
  const Command command = commands.add(
      "sim-rays", "Sends an image's rays through a compressed tree in DRAM, cycle by cycle; compares hits and traffic",
      [options] { return run(*options); });
  command.add_option("scene", options->scene, "a .glb, .gltf, .obj or .ply file, or proc:NAME[,key=value...]")
      .type_name("SCENE");
  command.add_option("--rays", options->rays, "primary, or diffuse: one from where each of them hits")
      .capture_default_str();
  command.add_option("--width", options->width, "pixels in a row").capture_default_str();
  command.add_option("--height", options->height, "rows").capture_default_str();
  command.add_option("--slots", options->slots, "rays that the unit has on their way at once, 1..64")
      .capture_default_str();
  options->sim.add_to(command);
  command.footer(golden::procedural_scene_help());
  options->output.add_option(command);
}

}  // namespace cbvh::testbench
