// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/build/median.h"

#include "golden/build/build_limits.h"
#include "golden/build/subtree_arrays.h"
#include "golden/build/top_grid.h"
#include "golden/scene/mesh_check.h"

namespace cbvh::golden {
namespace {

/// A plane between centroids.
struct Plane {
  int axis;
  float place;
  bool is_left(const Reference& reference) const { return reference.box().centroid()[axis] < place; }
};

Plane middle_of(const WideBox& region) {
  const int axis = longest_axis(region);
  return {axis, region.lower[axis] * 0.5F + region.upper[axis] * 0.5F};
}

class MedianSubtrees {
 public:
  MedianSubtrees(const BuildLimits& limits, SubtreeArrays& arrays) : limits_(limits), arrays_(arrays) {}

  void build(const Subtree& node) { build(node, arrays_.centroids(node)); }

 private:
  /// At most 64 deep. `region` holds all centroids.
  void build(const Subtree& node, WideBox region) {
    const double area = half_area(node.box);
    if (limits_.prefer_leaf(node.count, node.levels, area, 0)) return arrays_.make_leaf(node);
    Plane plane = middle_of(region);
    std::uint32_t left = count_left(node, plane);
    if (left == 0 || left == node.count) {
      region = arrays_.centroids(node);
      plane = middle_of(region);
      left = count_left(node, plane);
    }
    const bool can_be_halved = left > 0 && left < node.count;
    if (node.count <= limits_.leaf &&
        limits_.prefer_leaf(node.count, node.levels, area, can_be_halved ? cost(node, plane) : kNoSplit)) {
      return arrays_.make_leaf(node);
    }
    if (!(area > 0) || !can_be_halved || !limits_.fit(left, node.count - left, node.levels)) {
      for (const Subtree& half : arrays_.divide_at_median(node)) build(half);
      return;
    }
    const auto halves =
        arrays_.divide(node, left, [&](std::uint32_t, const Reference& reference) { return plane.is_left(reference); });
    std::array<WideBox, 2> regions{region, region};
    regions[0].upper[plane.axis] = plane.place;
    regions[1].lower[plane.axis] = plane.place;
    for (std::size_t i = 0; i < 2; ++i) build(halves[i], regions[i]);
  }

  std::uint32_t count_left(const Subtree& node, const Plane& plane) {
    std::uint32_t left = 0;
    for (const Reference& reference : arrays_.references(node)) left += plane.is_left(reference) ? 1 : 0;
    return left;
  }

  /// Half area times count, of both halves; neither is empty.
  double cost(const Subtree& node, const Plane& plane) {
    std::array<WideBox, 2> boxes;
    std::array<double, 2> counts{};
    for (const Reference& reference : arrays_.references(node)) {
      const std::size_t half = plane.is_left(reference) ? 0 : 1;
      boxes[half].enclose(reference.box());
      ++counts[half];
    }
    return half_area(boxes[0]) * counts[0] + half_area(boxes[1]) * counts[1];
  }

  static constexpr double kNoSplit = std::numeric_limits<double>::infinity();
  const BuildLimits& limits_;
  SubtreeArrays& arrays_;
};

/// Cells of a few triangles: halving a grid costs less than halving nodes.
constexpr int kGridLevels = 12;

FloatTree build(const Mesh& mesh, const OptionValues& options) {
  check_mesh(mesh, mesh.name);
  const BuildLimits limits = build_limits(options, mesh.triangles.size(), mesh.name);
  SubtreeArrays arrays(static_cast<std::uint32_t>(mesh.triangles.size()));
  MedianSubtrees builder(limits, arrays);
  build_subtrees(split_by_grid(mesh, limits, kGridLevels, arrays), limits.threads,
                 [&](const Subtree& subtree) { builder.build(subtree); });
  return emit(arrays.tree(), mesh.triangles.size(), mesh.name, limits.threads);
}

}  // namespace

BuilderKind median_builder() {
  std::vector<Option> options = limit_options();
  options.push_back(threads_option());
  return {"median", "spatial median of the centroids' box, as in a BIH (Wald, Ize, Parker, section 5)",
          std::move(options), build};
}

}  // namespace cbvh::golden
