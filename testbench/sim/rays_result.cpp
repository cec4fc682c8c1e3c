// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "golden/trace/camera.h"
#include "golden/trace/random.h"
#include "golden/trace/surface.h"
#include "golden/trace/traced_mesh.h"
#include "testbench/sim/simulate_rays.h"

namespace cbvh::testbench {

std::vector<golden::Ray> image_rays(const golden::Mesh& mesh, const golden::FloatTree& tree, SimulatedRays kind,
                                    unsigned width, unsigned height) {
  const golden::Camera camera = golden::Camera::around(tree.scene);
  const golden::SceneScale scale = golden::scene_scale(tree.scene);
  golden::TracedMesh<golden::FloatTreeView> traced(golden::FloatTreeView(tree), mesh);
  std::vector<golden::Ray> rays;
  for (unsigned y = 0; y < height; ++y) {
    for (unsigned x = 0; x < width; ++x) {
      const golden::Ray ray = camera.ray(x, y, width, height);
      if (kind == SimulatedRays::primary) {
        rays.push_back(ray);
        continue;
      }
      const auto surface = traced.surface(ray, traced.trace(ray, golden::Stop::closest));
      if (!surface) continue;
      golden::CounterRandom random(std::uint64_t{y} * width + x, 0, 0);
      const golden::Ray next = golden::leaving(*surface, golden::diffuse_direction(surface->normal, random), scale);
      if (golden::can_leave(next)) rays.push_back(next);
    }
  }
  return rays;
}

std::string to_text(const RaysResult& result) {
  const double rate = static_cast<double>(result.rays) / static_cast<double>(result.cycles) * result.clock_mhz;
  std::string text = fmt::format("{}: {} rays, {} of them hit, through {} pairs\n", result.scene, result.rays,
                                 result.hits, result.tree_pairs);
  text += fmt::format("{:<16} {:>12} {:>14} {:>12}\n", "a ray", "this unit", "exact distances", "float tree");
  text += fmt::format("{:<16} {:>12.2f} {:>14.2f} {:>12.2f}\n", "pairs", result.per_ray(result.pairs),
                      result.per_ray(result.exact_pairs), result.per_ray(result.float_pairs));
  text += fmt::format("{:<16} {:>12.2f} {:>14} {:>12.2f}\n", "bytes of pairs", result.per_ray(64 * result.pair_lines),
                      "", result.per_ray(64 * result.float_pairs));
  text += fmt::format("{:<16} {:>12.2f} {:>14} {:>12.2f}\n", "triangles", result.per_ray(result.candidates), "",
                      result.per_ray(result.float_triangles));
  text += fmt::format("{:<16} {:>12.2f}\n", "bytes of IDs", result.per_ray(64 * result.id_lines));
  text += fmt::format("{:<16} {:>12.2f}\n", "cycles", result.per_ray(result.cycles));
  if (result.bound_cycles > 0) {
    text += fmt::format("{:<16} {:>12.2f}  the bytes at the memory's peak\n", "bound",
                        result.bound_cycles / static_cast<double>(result.rays));
  }
  text += fmt::format("{:.2f} million rays a second at {:.0f} MHz; {:.0f} rays, {:.0f} cycles a second simulated\n",
                      rate, result.clock_mhz, static_cast<double>(result.rays) / result.seconds,
                      static_cast<double>(result.cycles) / result.seconds);
  text += result.wrong == 0 ? fmt::format("every nearest hit is the golden's: {} checked\n", result.rays)
                            : fmt::format("{} wrong, the first: {}\n", result.wrong, result.first_wrong);
  return text;
}

Json to_json(const RaysResult& result) {
  Json memory = Json::array();
  for (const MemoryStatistic& row : result.memory) {
    memory.push_back({{"name", row.name}, {"unit", row.unit}, {"description", row.description}, {"value", row.value}});
  }
  return {
      {"scene", result.scene},
      {"rays", result.rays},
      {"tree_pairs", result.tree_pairs},
      {"hits", result.hits},
      {"wrong", result.wrong},
      {"first_wrong", result.first_wrong},
      {"unit",
       {{"pairs", result.pairs},
        {"leaves", result.leaves},
        {"triangles", result.candidates},
        {"pair_bytes", 64 * result.pair_lines},
        {"id_bytes", 64 * result.id_lines},
        {"cycles", result.cycles},
        {"bound_cycles", result.bound_cycles},
        {"cycles_per_ray", result.per_ray(result.cycles)}}},
      {"exact_boxes", {{"pairs", result.exact_pairs}}},
      {"float_tree",
       {{"pairs", result.float_pairs}, {"pair_bytes", 64 * result.float_pairs}, {"triangles", result.float_triangles}}},
      {"clock_mhz", result.clock_mhz},
      {"rays_per_second_simulated", static_cast<double>(result.rays) / result.seconds},
      {"memory", memory},
      {"pass", result.pass()}};
}

}  // namespace cbvh::testbench
