// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// Our builders beside Embree's on the same meshes, in one run: seconds from triangles to tree, the least of several
// rounds in which all take turns, and the SAH cost of the trees, counted the same way. Ratios are ours to Embree's.
// With --scaling: what a second thread brings our builders, in the same way.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <thread>

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
                                       {"sweep", RTC_BUILD_QUALITY_MEDIUM, "MEDIUM"},
                                       {"spatial", RTC_BUILD_QUALITY_HIGH, "HIGH"},
                                       {"spatial,objects=1", RTC_BUILD_QUALITY_HIGH, "HIGH"}};

constexpr const char* kThreaded[] = {"binned", "binned,bins=32", "binned,top=grid", "median"};

struct Settings {
  std::vector<std::string> scenes;
  std::vector<std::string> only;
  int rounds = 7;
  int threads = 1;
  int leaf = 4;
  bool scaling = false;

  bool has(const std::string& builder) const {
    return only.empty() || std::find(only.begin(), only.end(), builder) != only.end();
  }
};

/// "NAME[,key=value...]" with these options too, as far as it has them.
golden::Builder builder_with(const std::string& description, int leaf, int threads) {
  const golden::BuilderKind& kind = golden::Builder("builder", description).kind();
  std::string text = description;
  const auto add = [&](const char* name, int value) {
    if (golden::find_named(kind.options, name) != nullptr) text += fmt::format(",{}={}", name, value);
  };
  add("leaf", leaf);
  add("threads", threads);
  return {"builder", text};
}

struct TimedTree {
  double seconds;  ///< from triangles to tree
  golden::FloatTree tree;
};

TimedTree timed_build(const golden::Builder& builder, const golden::Mesh& mesh) {
  const auto start = std::chrono::steady_clock::now();
  golden::FloatTree tree = builder.build(mesh);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return {seconds, std::move(tree)};
}

void compare(const golden::Mesh& mesh, const Comparison& pair, const Embree& embree, const Settings& settings) {
  const golden::Builder builder = builder_with(pair.ours, settings.leaf, settings.threads);
  const golden::SahCosts costs;
  double ours = 1e9;
  double theirs = 1e9;
  double scene = 1e9;
  double our_sah = 0;
  double their_sah = 0;
  for (int round = 0; round < settings.rounds; ++round) {
    const TimedTree mine = timed_build(builder, mesh);
    ours = std::min(ours, mine.seconds);
    our_sah = golden::sah(mine.tree, costs);
    const Embree::Tree other = embree.build(mesh, pair.quality, static_cast<unsigned>(settings.leaf), costs);
    theirs = std::min(theirs, other.seconds);
    their_sah = other.sah;
    scene = std::min(scene, embree.commit(mesh, pair.quality));
  }
  fmt::print("{:24} {:18} {:8.2f} {:8} {:8.2f} {:6.2f} {:9.2f} {:6.2f} {:8.3f} {:8.3f} {:7.4f}\n",
             mesh.name.substr(0, 24), pair.ours, ours * 1e3, pair.theirs, theirs * 1e3, ours / theirs, scene * 1e3,
             ours / scene, our_sah, their_sah, our_sah / their_sah);
}

void compare_all(const Settings& settings) {
  const Embree embree(settings.threads);
  fmt::print("{:24} {:18} {:>8} {:8} {:>8} {:>6} {:>9} {:>6} {:>8} {:>8} {:>7}\n", "scene", "ours", "ms", "Embree",
             "tree ms", "ratio", "commit ms", "ratio", "SAH", "Embree", "ratio");
  for (const std::string& scene : settings.scenes) {
    const golden::Mesh mesh = golden::load_scene(scene);
    for (const Comparison& pair : kComparisons) {
      if (settings.has(pair.ours)) compare(mesh, pair, embree, settings);
    }
  }
}

/// Seconds of two builds side by side, each on a thread of its own: what the machine's second core is good for.
double two_at_once(const golden::Builder& builder, const golden::Mesh& mesh) {
  const auto start = std::chrono::steady_clock::now();
  {
    const std::jthread other([&] { timed_build(builder, mesh); });
    timed_build(builder, mesh);
  }
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// One thread, two, and two builds at once, in turns.
void scale_all(const Settings& settings) {
  fmt::print("{:24} {:16} {:>8} {:>10} {:>7} {:>8}\n", "scene", "ours", "ms", "2 threads", "faster", "possible");
  for (const std::string& scene : settings.scenes) {
    const golden::Mesh mesh = golden::load_scene(scene);
    for (const char* ours : kThreaded) {
      if (!settings.has(ours)) continue;
      const golden::Builder alone = builder_with(ours, settings.leaf, 1);
      const golden::Builder together = builder_with(ours, settings.leaf, 2);
      double one = 1e9;
      double two = 1e9;
      double both = 1e9;
      for (int round = 0; round < settings.rounds; ++round) {
        one = std::min(one, timed_build(alone, mesh).seconds);
        two = std::min(two, timed_build(together, mesh).seconds);
        both = std::min(both, two_at_once(alone, mesh));
      }
      fmt::print("{:24} {:16} {:8.2f} {:10.2f} {:7.2f} {:8.2f}\n", mesh.name.substr(0, 24), ours, one * 1e3, two * 1e3,
                 one / two, 2 * one / both);
    }
  }
}

int run(int argc, char** argv) {
  CLI::App app("Our builders against Embree's: build time and SAH cost");
  Settings settings;
  app.add_option("scene", settings.scenes, "as cbvh build takes them")->required()->type_name("SCENE");
  app.add_option("--only", settings.only, "this row of the table; again for more of them")
      ->allow_extra_args(false)
      ->type_name("BUILDER");
  app.add_option("--rounds", settings.rounds, "the least time of so many counts")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  CLI::Option* threads =
      app.add_option("--threads", settings.threads, "for both")->check(CLI::Range(1, 256))->capture_default_str();
  app.add_option("--leaf", settings.leaf, "most triangles a leaf")->check(CLI::Range(1, 32))->capture_default_str();
  app.add_flag("--scaling", settings.scaling, "ours alone: one thread, two, and what two builds at once make possible")
      ->excludes(threads);
  CLI11_PARSE(app, argc, argv);
  settings.scaling ? scale_all(settings) : compare_all(settings);
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
