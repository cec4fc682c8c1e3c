// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/eval/paper.h"

#include <fmt/format.h>

#include <algorithm>

namespace cbvh::testbench {

const std::vector<PaperScene>& paper_scenes() {
  static const std::vector<PaperScene> scenes = {
      {"Toasters", {0.2, 0.2, 0.3, 0.1}, 1.1},    {"Bunny", {1.1, 1.6, 1.9, 0.8}, 1.1},
      {"Elephant", {1.3, 1.9, 2.2, 1.0}, 1.1},    {"Cloth", {1.5, 2.1, 2.4, 1.1}, 1.0},
      {"Fairy", {2.1, 2.5, 2.6, 1.9}, 3.8},       {"Armadillo", {3.4, 4.8, 5.7, 2.6}, 1.2},
      {"Crytek", {3.6, 4.8, 5.4, 3.0}, 2.0},      {"Conference", {3.2, 3.5, 3.4, 2.9}, 8.7},
      {"Sportscar", {4.3, 5.8, 6.4, 3.5}, 1.9},   {"Italian", {5.0, 6.6, 7.7, 4.2}, 2.8},
      {"Babylonian", {6.7, 8.8, 10.2, 5.6}, 2.4}, {"Hand", {9.6, 13.3, 15.2, 7.6}, 1.5},
      {"Dragon", {13.4, 19.0, 21.5, 10.3}, 1.3},  {"Buddha", {16.7, 23.5, 26.0, 13.0}, 1.5},
      {"Lion", {23.9, 33.6, 37.7, 18.7}, 1.3},    {"Hairball", {40.9, 56.5, 52.2, 32.2}, 1.4}};
  return scenes;
}

const PaperSpread kPaperBacktracks = {{1.00, 0.06, 0.01, 0.00, 0.10, 0.02, 0.00, 0.00},
                                      {1.00, 0.25, 0.09, 0.03, 0.44, 0.15, 0.06, 0.03},
                                      {1.00, 0.15, 0.04, 0.01, 0.22, 0.06, 0.02, 0.01}};
const PaperSpread kPaperLbvhTraffic = {{0.75, 0.53, 0.51, 0.50, 0.54, 0.51, 0.50, 0.50},
                                       {0.95, 0.86, 0.84, 0.83, 0.87, 0.84, 0.83, 0.83},
                                       {0.84, 0.61, 0.59, 0.58, 0.63, 0.59, 0.58, 0.58}};
const PaperSpread kPaperRefitTraffic = {{0.67, 0.41, 0.39, 0.38, 0.42, 0.39, 0.38, 0.38},
                                        {0.90, 0.74, 0.70, 0.69, 0.76, 0.71, 0.69, 0.68},
                                        {0.79, 0.49, 0.45, 0.44, 0.52, 0.46, 0.44, 0.44}};

namespace {

/// A scene that a reader may take for one of the paper's.
struct Lookalike {
  std::string_view name;  ///< how our scene's name starts
  const char* paper;
  std::uint64_t same_triangles;  ///< it is the paper's scene if it has so many; 0: it never is
  const char* otherwise;
};

// The Stanford bunny has 69,451 triangles.
constexpr Lookalike kLookalikes[] = {
    {"bunny", "Bunny", 69451, "another mesh than the paper's Bunny, which has 69451 triangles"},
    {"dragon", "Dragon", 0, "the paper's Dragon is a modified copy of the Stanford dragon (leaf size 1.3)"},
    {"armadillo", "Armadillo", 0, "another, smaller mesh than the paper's Armadillo (leaf size 1.2)"},
    {"sponza", "Crytek", 0, "another model of the building than the paper's Crytek (leaf size 2.0)"},
    {"proc:cloth", "Cloth", 0, "in the spirit of the paper's Cloth (leaf size 1.0), not a copy"},
    {"proc:hairball", "Hairball", 0, "like the paper's Hairball (leaf size 1.4) in kind only"}};

const PaperScene* find(std::string_view name) {
  const auto& scenes = paper_scenes();
  const auto found = std::find_if(scenes.begin(), scenes.end(), [&](const PaperScene& s) { return s.name == name; });
  return found == scenes.end() ? nullptr : &*found;
}

/// "x" of "x", "folder/x.glb" and "X.GLB".
std::string bare_name(const std::string& name) {
  std::string bare = name.substr(name.find_last_of('/') + 1);
  std::transform(bare.begin(), bare.end(), bare.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return bare;
}

}  // namespace

PaperCounterpart paper_counterpart(const SceneMeasure& scene) {
  const std::string name = bare_name(scene.name);
  for (const Lookalike& known : kLookalikes) {
    if (!std::string_view(name).starts_with(known.name)) continue;
    if (scene.triangles == known.same_triangles) return {find(known.paper), fmt::format("the paper's {}", known.paper)};
    return {nullptr, known.otherwise};
  }
  for (const PaperScene& paper : paper_scenes()) {
    if (std::string_view(name).starts_with(bare_name(paper.name)))
      return {nullptr, fmt::format("not known to be the paper's {} (leaf size {:.1f})", paper.name, paper.leaf_size)};
  }
  return {};
}

}  // namespace cbvh::testbench
