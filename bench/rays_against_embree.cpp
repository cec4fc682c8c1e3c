// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// The reference tracer through float and compressed trees beside Embree's single rays, on one thread, in one run: the
// same rays, a share at a time in turn, in the thread's processor time, so that what else the machine does matters
// little. Ratios are ours to Embree's, and compressed to float.
#include <fmt/format.h>

#include <time.h>

#include <CLI/CLI.hpp>

#include "golden/build/builder.h"
#include "golden/input_error.h"
#include "golden/quantize/scale.h"
#include "golden/scene/load.h"
#include "golden/trace/compressed_view.h"
#include "golden/update/top_down.h"
#include "testbench/trace/embree/embree_scene.h"
#include "testbench/trace/hits/ray_sets.h"

namespace cbvh::bench {
namespace {

using testbench::RaySet;

constexpr std::size_t kShare = 2000;

struct Settings {
  std::vector<std::string> scenes;
  std::string builder = "sweep";
  std::size_t rays = 200'000;
};

double processor_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Adds what tracing a share of the rays takes, and how many hit.
struct Racer {
  double seconds = 0;
  std::size_t hits = 0;

  template <class Trace>
  void run(const std::vector<golden::Ray>& rays, const Trace& hit) {
    const double start = processor_seconds();
    for (const golden::Ray& ray : rays) hits += hit(ray) != golden::Hit::kNone ? 1 : 0;
    seconds += processor_seconds() - start;
  }
  double millions(std::size_t rays) const { return static_cast<double>(rays) / seconds * 1e-6; }
};

/// Rays of a picture's first bounce are as good as random ones; these are random.
void compare(const golden::Mesh& mesh, const Settings& settings) {
  const golden::FloatTree tree = golden::Builder("--builder", settings.builder).build(mesh);
  const golden::GridRules rules{.min_scale = golden::exactness_limit(tree.largest_magnitude)};
  const golden::CompressedTree compressed_tree = golden::compress_top_down(tree, rules, golden::Code::modulo);
  golden::Tracer floats{golden::FloatTreeView(tree), mesh};
  golden::Tracer compressed{golden::CompressedTreeView(compressed_tree), mesh};
  const testbench::EmbreeScene embree(mesh, false);
  const testbench::EmbreeScene robust(mesh, true);
  Racer racers[4];
  std::size_t number = 0;
  while (number < settings.rays) {
    std::vector<golden::Ray> rays(kShare);
    for (golden::Ray& ray : rays) ray = testbench::made_ray(RaySet::incoherent, mesh, tree.scene, 1, number++);
    racers[0].run(rays, [&](const golden::Ray& ray) { return floats.trace(ray, golden::Stop::closest).primitive; });
    racers[1].run(rays, [&](const golden::Ray& ray) { return compressed.trace(ray, golden::Stop::closest).primitive; });
    racers[2].run(rays, [&](const golden::Ray& ray) { return embree.trace(ray).primitive; });
    racers[3].run(rays, [&](const golden::Ray& ray) { return robust.trace(ray).primitive; });
  }
  fmt::print("{:24} {:>9} {:>6.1f} {:>8.3f} {:>10.3f} {:>8.3f} {:>8.3f} {:>10.3f} {:>8.3f} {:>8.3f}\n",
             mesh.name.substr(0, 24), number, 100 * static_cast<double>(racers[0].hits) / static_cast<double>(number),
             racers[0].millions(number), racers[1].millions(number), racers[2].millions(number),
             racers[3].millions(number), racers[0].seconds / racers[1].seconds, racers[2].seconds / racers[0].seconds,
             racers[2].seconds / racers[1].seconds);
}

int run(int argc, char** argv) {
  CLI::App app("The reference tracer's incoherent rays beside Embree's, on one thread");
  Settings settings;
  app.add_option("scene", settings.scenes, "as cbvh build takes them")->required()->type_name("SCENE");
  app.add_option("--builder", settings.builder, "of our trees; Embree builds its own")->capture_default_str();
  app.add_option("--rays", settings.rays, "of each scene")->check(CLI::PositiveNumber)->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  fmt::print("million rays a second; ratios\n{:24} {:>9} {:>6} {:>8} {:>10} {:>8} {:>8} {:>10} {:>8} {:>8}\n", "scene",
             "rays", "hit %", "float", "compressed", "Embree", "robust", "c / float", "f / E", "c / E");
  for (const std::string& scene : settings.scenes) compare(golden::load_scene(scene), settings);
  return 0;
}

}  // namespace
}  // namespace cbvh::bench

int main(int argc, char** argv) {
  try {
    return cbvh::bench::run(argc, argv);
  } catch (const cbvh::golden::InputError& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 2;
  }
}
