// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/eval/space/trees.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

namespace cbvh::testbench {

namespace {

constexpr const char* kCosts = "leaf=16,intersection=1.5";
constexpr const char* kEverything = "generic,oracle=all";

enum class PaperScene001 : std::uint8_t { bunny, sponza, rotated };

/// Figures as the paper's tables have them; 0: none.
struct PaperTree {
  PaperScene001 scene;
  const char* tree;
  double megabytes;
  double expected;
  double cost;     ///< a ray that terminates
  double through;  ///< one that does not
};

using enum PaperScene001;
constexpr PaperTree kPaperTrees[] = {{bunny, "C-BVH", 1.0, 66.6, 32.6, 0},
                                     {bunny, "GP-BVH", 0, 68.1, 33.7, 0},
                                     {bunny, "G-BVH", 3.1, 67.2, 31.6, 0},
                                     {bunny, "GK-BVH", 3.1, 69.0, 32.3, 0},
                                     {bunny, "SS-BVH", 3.1, 69.0, 32.3, 0},
                                     {bunny, "KD-BVH", 6.6, 95.3, 43.7, 0},
                                     {sponza, "C-BVH", 1.0, 142.6, 68.3, 195.3},
                                     {sponza, "GP-BVH", 0, 167.1, 85.5, 0},
                                     {sponza, "GP-BVH, recursive", 0, 124.0, 93.0 * 68.3 / 85.3, 177.5},
                                     {sponza, "EVH-BVH, t = 14", 1.0, 142.6, 68.3, 0},
                                     {sponza, "EVH-BVH, t = 16", 1.0, 142.6, 68.3, 0},
                                     {sponza, "ESC-BVH, 200", 1.1, 142.6 * 167 / 142, 68.3 * 96 / 85, 0},
                                     {sponza, "ESC-BVH, 80", 1.1, 142.6 * 185 / 142, 68.3 * 103 / 85, 0},
                                     {sponza, "G-BVH", 2.6, 121.2, 43.2, 0},
                                     {sponza, "GK-BVH", 2.8, 119.3, 43.0, 0},
                                     {sponza, "KD-BVH", 8.0, 120.7, 43.1, 0},
                                     {sponza, "SS-BVH", 2.8, 119.3, 43.0, 0},
                                     {rotated, "C-BVH", 1.0, 144, 396, 0},
                                     {rotated, "EVH-BVH, t = 14", 1.3, 148, 190, 0},
                                     {rotated, "EVH-BVH, t = 16", 1.6, 154, 170, 0},
                                     {rotated, "ESC-BVH, 200", 1.2, 147, 196, 0},
                                     {rotated, "ESC-BVH, 80", 1.3, 155, 179, 0},
                                     {rotated, "G-BVH", 11.4, 86, 100, 0},
                                     {rotated, "SS-BVH, 1.5 references", 1.5, 134, 199, 0},
                                     {rotated, "SS-BVH, 2.5 references", 2.6, 120, 175, 0},
                                     {rotated, "SS-BVH, 4 references", 4.3, 101, 134, 0},
                                     {rotated, "SS-BVH", 10.3, 87, 100, 0}};

std::optional<PaperScene001> paper_scene(const std::string& scene) {
  std::string bare;
  for (const char c : scene.substr(scene.find_last_of("/:") + 1))
    bare += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  const bool turned = scene.starts_with("rotated:");
  if (bare.starts_with("sponza")) return turned ? rotated : sponza;
  if (bare.starts_with("bunny") && !turned) return bunny;
  return std::nullopt;
}

const PaperTree* paper_tree(PaperScene001 scene, const std::string& name) {
  const auto* const found = std::find_if(std::begin(kPaperTrees), std::end(kPaperTrees), [&](const PaperTree& tree) {
    return tree.scene == scene && tree.tree == name;
  });
  return found == std::end(kPaperTrees) ? nullptr : found;
}

std::optional<double> ratio(double figure, double of_sweep) {
  return figure > 0 && of_sweep > 0 ? std::optional<double>(figure / of_sweep) : std::nullopt;
}

}  // namespace

std::vector<SpaceTree> paper_space_trees() {
  const auto with_costs = [](const std::string& builder) { return fmt::format("{},{}", builder, kCosts); };
  const std::string everything = kEverything;
  return {{"C-BVH", with_costs("sweep")},
          {"GP-BVH", with_costs("geometric,resolution=64")},
          {"GP-BVH, recursive", with_costs("generic,oracle=centroid+grid,split=0,recursion=16")},
          {"EVH-BVH, t = 14", with_costs("edge-volume,t=14")},
          {"EVH-BVH, t = 16", with_costs("edge-volume,t=16")},
          {"ESC-BVH, 200", with_costs("early-split,area=0.0005")},
          {"ESC-BVH, 80", with_costs("early-split,area=0.0002")},
          {"G-BVH", with_costs(everything + ",overlap=1e16")},
          {"GK-BVH", with_costs("generic,oracle=kd")},
          {"KD-BVH", with_costs("kdtree")},
          {"SS-BVH, 1.5 references", with_costs("spatial"), 1.5},
          {"SS-BVH, 2.5 references", with_costs("spatial"), 2.5},
          {"SS-BVH, 4 references", with_costs("spatial"), 4},
          {"SS-BVH", with_costs("spatial")},
          {"SS-BVH and objects", with_costs("spatial,objects=1")}};
}

SpaceTree overlap_tree(double penalty) {
  return {fmt::format("C_O = {}", penalty), fmt::format("{},overlap={},{}", kEverything, penalty, kCosts)};
}

std::string builder_text(const SpaceTree& tree, std::uint64_t triangles) {
  if (tree.reference_factor <= 0) return tree.builder;
  const double references = std::ceil(tree.reference_factor * static_cast<double>(triangles));
  return fmt::format("{},references={}", tree.builder, static_cast<std::uint64_t>(references));
}

PaperSpaceRatios paper_space_ratios(const std::string& scene, const std::string& tree) {
  const auto which = paper_scene(scene);
  if (!which) return {};
  const PaperTree* const sweep = paper_tree(*which, "C-BVH");
  const PaperTree* const found = paper_tree(*which, tree);
  if (found == nullptr) return {};
  return {ratio(found->megabytes, sweep->megabytes), ratio(found->expected, sweep->expected),
          ratio(found->cost, sweep->cost), ratio(found->through, sweep->through)};
}

}  // namespace cbvh::testbench
