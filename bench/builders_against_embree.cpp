// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// Our builders beside Embree's on the same meshes, in one run: seconds from triangles to tree, the least of several
// rounds in which all take turns, and the SAH cost of the trees, counted the same way. Ratios are ours to Embree's.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>

#include "bench/embree_tree.h"
#include "golden/build/builder.h"
#include "golden/input_error.h"
#include "golden/scene/load.h"

namespace cbvh::bench {
namespace {

struct Comparison {
  const char* ours;
  RTCBuildQuality quality;
  const char* theirs;
};
constexpr Comparison kComparisons[] = {{"lbvh", RTC_BUILD_QUALITY_LOW, "LOW"},
                                       {"binned", RTC_BUILD_QUALITY_MEDIUM, "MEDIUM"},
                                       {"binned,bins=32", RTC_BUILD_QUALITY_MEDIUM, "MEDIUM"},
                                       {"sweep", RTC_BUILD_QUALITY_MEDIUM, "MEDIUM"}};

struct Settings {
  std::vector<std::string> scenes;
  int rounds = 7;
  int threads = 1;
  int leaf = 4;
};

std::string with_options(const char* ours, const golden::BuilderKind& kind, const Settings& settings) {
  std::string text = ours;
  const auto add = [&](const char* name, int value) {
    if (golden::find_named(kind.options, name) != nullptr) text += fmt::format(",{}={}", name, value);
  };
  add("threads", settings.threads);
  add("leaf", settings.leaf);
  return text;
}

void compare(const golden::Mesh& mesh, const Comparison& pair, const Embree& embree, const Settings& settings) {
  const golden::BuilderKind* kind = golden::find_named(golden::builder_kinds(), golden::name_of(pair.ours));
  const golden::Builder builder("builder", with_options(pair.ours, *kind, settings));
  const golden::SahCosts costs;
  double ours = 1e9;
  double theirs = 1e9;
  double scene = 1e9;
  double our_sah = 0;
  double their_sah = 0;
  for (int round = 0; round < settings.rounds; ++round) {
    const auto start = std::chrono::steady_clock::now();
    const golden::FloatTree tree = builder.build(mesh);
    ours = std::min(ours, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    our_sah = golden::sah(tree, costs);
    const Embree::Tree other = embree.build(mesh, pair.quality, static_cast<unsigned>(settings.leaf), costs);
    theirs = std::min(theirs, other.seconds);
    their_sah = other.sah;
    scene = std::min(scene, embree.commit(mesh, pair.quality));
  }
  fmt::print("{:24} {:16} {:8.2f} {:8} {:8.2f} {:6.2f} {:9.2f} {:6.2f} {:8.3f} {:8.3f} {:7.4f}\n",
             mesh.name.substr(0, 24), pair.ours, ours * 1e3, pair.theirs, theirs * 1e3, ours / theirs, scene * 1e3,
             ours / scene, our_sah, their_sah, our_sah / their_sah);
}

int run(int argc, char** argv) {
  CLI::App app("Our builders against Embree's: build time and SAH cost");
  Settings settings;
  app.add_option("scene", settings.scenes, "as cbvh build takes them")->required()->type_name("SCENE");
  app.add_option("--rounds", settings.rounds, "the least time of so many counts")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  app.add_option("--threads", settings.threads, "for both")->check(CLI::Range(1, 256))->capture_default_str();
  app.add_option("--leaf", settings.leaf, "most triangles a leaf")->check(CLI::Range(1, 32))->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  const Embree embree(settings.threads);
  fmt::print("{:24} {:16} {:>8} {:8} {:>8} {:>6} {:>9} {:>6} {:>8} {:>8} {:>7}\n", "scene", "ours", "ms", "Embree",
             "tree ms", "ratio", "commit ms", "ratio", "SAH", "Embree", "ratio");
  for (const std::string& scene : settings.scenes) {
    const golden::Mesh mesh = golden::load_scene(scene);
    for (const Comparison& pair : kComparisons) compare(mesh, pair, embree, settings);
  }
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
