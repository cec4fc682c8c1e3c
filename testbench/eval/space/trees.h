// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace cbvh::testbench {

/// A tree of paper 001 under the paper's name, and the builder that makes it here.
struct SpaceTree {
  std::string name;
  std::string builder;          ///< "NAME[,key=value...]"
  double reference_factor = 0;  ///< above 0: at most so many references a triangle
};

/// The paper's costs: C_T = 1, and C_I such that its tables' sums come out (46.7 + C_I 14.4 = 68.3).
inline constexpr double kSpaceTraversal = 1;
inline constexpr double kSpaceIntersection = 1.5;

/// Those of Tables 1 to 4, the centroid sweep first.
std::vector<SpaceTree> paper_space_trees();
/// G-BVH with that penalty on overlap (Figure 6).
SpaceTree overlap_tree(double penalty);

/// The text of a tree's builder for a scene of so many triangles.
std::string builder_text(const SpaceTree& tree, std::uint64_t triangles);

/// The paper's figures for a tree over its figures for the centroid sweep of the same scene. Random rays (Tables 3, 4);
/// where the paper has none, primary rays (Tables 1, 2).
struct PaperSpaceRatios {
  std::optional<double> size;
  std::optional<double> expected;
  std::optional<double> terminating;
  std::optional<double> through;  ///< rays that do not terminate
};

/// Nothing for a scene or tree the paper does not have; its scenes are bunny, sponza and rotated:sponza.
PaperSpaceRatios paper_space_ratios(const std::string& scene, const std::string& tree);

}  // namespace cbvh::testbench
