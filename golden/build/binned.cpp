// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/build/binned.h"

#include "golden/build/build_limits.h"
#include "golden/build/sah_bins.h"
#include "golden/build/small_sweep.h"
#include "golden/build/subtree_arrays.h"
#include "golden/build/top_binning.h"
#include "golden/build/top_grid.h"
#include "golden/scene/mesh_check.h"

namespace cbvh::golden {
namespace {

/// The grid need only give all threads enough to do: the fewer of its medians, the better the tree.
constexpr int kGridLevels = 6;

class BinnedSubtrees {
 public:
  BinnedSubtrees(const BuildLimits& limits, int bins, SubtreeArrays& arrays)
      : limits_(limits), bin_count_(bins), bins_(bins), arrays_(arrays) {}

  void build(const Subtree& node) { build(node, arrays_.centroids(node)); }

 private:
  /// At most 64 deep. `centroids`: their box.
  void build(const Subtree& node, const WideBox& centroids) {
    if (node.count <= static_cast<std::uint32_t>(bin_count_)) return build_swept(node);
    const double area = half_area(node.box);
    if (limits_.prefer_leaf(node.count, node.levels, area, 0)) return arrays_.make_leaf(node);
    const BinMapping mapping(centroids, bin_count_);
    bins_.clear();
    for (const Reference& reference : arrays_.references(node))
      bins_.add(mapping.bin_of(reference.box().centroid()), reference.box(), 1);
    const Split split = bins_.best();
    if (limits_.prefer_leaf(node.count, node.levels, area, split.cost)) return arrays_.make_leaf(node);
    if (!limits_.usable(split, area, node.count, node.levels)) {
      for (const Subtree& half : arrays_.divide_at_median(node)) build(half);
      return;
    }
    const auto position = static_cast<std::int32_t>(split.position);
    std::array<WideBox, 2> of_halves;
    arrays_.move(node, split.left, [&](std::uint32_t, const Reference& reference) {
      const Float4 centroid = reference.box().centroid();
      const bool is_left = mapping.bin_of(centroid)[split.axis] < position;
      of_halves[is_left ? 0 : 1].enclose(centroid);
      return is_left;
    });
    const std::array<Subtree, 2> halves = arrays_.split(node, split.left, bins_.boxes(split));
    build(halves[0], of_halves[0]);
    build(halves[1], of_halves[1]);
  }

  /// No more references than bins.
  void build_swept(const Subtree& node) {
    const double area = half_area(node.box);
    if (limits_.prefer_leaf(node.count, node.levels, area, 0)) return arrays_.make_leaf(node);
    const SmallSweep sweep(arrays_.references(node));
    const Split& split = sweep.best();
    if (limits_.prefer_leaf(node.count, node.levels, area, split.cost)) return arrays_.make_leaf(node);
    const bool usable = limits_.usable(split, area, node.count, node.levels);
    const auto is_left = [&](std::uint32_t i, const Reference&) { return sweep.is_left(i); };
    for (const Subtree& half : usable ? arrays_.divide(node, split.left, is_left) : arrays_.divide_at_median(node))
      build_swept(half);
  }

  const BuildLimits& limits_;
  int bin_count_;
  SahBins bins_;
  SubtreeArrays& arrays_;
};

FloatTree build(const Mesh& mesh, const OptionValues& options) {
  check_mesh(mesh, mesh.name);
  const BuildLimits limits = build_limits(options, mesh.triangles.size(), mesh.name);
  const auto bins = static_cast<int>(options.integer("bins"));
  SubtreeArrays arrays(static_cast<std::uint32_t>(mesh.triangles.size()));
  const bool grid = options.word("top") == 1;
  build_subtrees(grid ? split_by_grid(mesh, limits, kGridLevels, arrays) : split_by_binning(mesh, limits, bins, arrays),
                 limits.threads, [&](const Subtree& subtree) { BinnedSubtrees(limits, bins, arrays).build(subtree); });
  return emit(arrays.tree(), mesh.triangles.size(), mesh.name, limits.threads);
}

}  // namespace

BuilderKind binned_builder() {
  std::vector<Option> options = limit_options();
  options.insert(options.begin(), {"bins", "bins an axis", 16, 4, kMaxBins});
  options.push_back(word_option("top", "how the scene is partitioned before its subtrees are built (section 5)",
                                {"binning", "grid"}));
  options.push_back(threads_option());
  return {"binned", "SAH between bins of centroids, on three axes (Wald, Ize, Parker, section 4)", std::move(options),
          build};
}

}  // namespace cbvh::golden
