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
      : limits_(limits), bins_(bins), arrays_(arrays) {}

  /// At most 64 deep.
  void build(const Subtree& node) {
    const double area = half_area(node.box);
    if (limits_.prefer_leaf(node.count, node.levels, area, 0)) return arrays_.make_leaf(node);
    if (node.count <= static_cast<std::uint32_t>(bins_)) {
      build_swept(node, area);
    } else {
      build_binned(node, area);
    }
  }

 private:
  void build_swept(const Subtree& node, double area) {
    const SmallSweep sweep(arrays_.references(node));
    const Split& split = sweep.best();
    if (limits_.prefer_leaf(node.count, node.levels, area, split.cost)) return arrays_.make_leaf(node);
    if (!limits_.usable(split, area, node.count, node.levels)) return build_both(arrays_.divide_at_median(node));
    build_both(arrays_.divide(node, split.left, [&](std::uint32_t i, const Reference&) { return sweep.is_left(i); }));
  }

  void build_binned(const Subtree& node, double area) {
    const BinMapping mapping(arrays_.centroids(node), bins_);
    SahBins bins(bins_);
    for (const Reference& reference : arrays_.references(node))
      bins.add(mapping.bin_of(reference.box().centroid()), reference.box(), 1);
    const Split split = bins.best();
    if (limits_.prefer_leaf(node.count, node.levels, area, split.cost)) return arrays_.make_leaf(node);
    if (!limits_.usable(split, area, node.count, node.levels)) return build_both(arrays_.divide_at_median(node));
    const auto position = static_cast<std::int32_t>(split.position);
    build_both(arrays_.divide(node, split.left, [&](std::uint32_t, const Reference& reference) {
      return mapping.bin_of(reference.box().centroid())[split.axis] < position;
    }));
  }

  void build_both(const std::array<Subtree, 2>& halves) {
    build(halves[0]);
    build(halves[1]);
  }

  const BuildLimits& limits_;
  int bins_;
  SubtreeArrays& arrays_;
};

FloatTree build(const Mesh& mesh, const OptionValues& options) {
  check_mesh(mesh, mesh.name);
  const BuildLimits limits = build_limits(options, mesh.triangles.size(), mesh.name);
  const auto bins = static_cast<int>(options.integer("bins"));
  SubtreeArrays arrays(static_cast<std::uint32_t>(mesh.triangles.size()));
  BinnedSubtrees builder(limits, bins, arrays);
  const bool grid = options.word("top") == 1;
  build_subtrees(grid ? split_by_grid(mesh, limits, kGridLevels, arrays) : split_by_binning(mesh, limits, bins, arrays),
                 limits.threads, [&](const Subtree& subtree) { builder.build(subtree); });
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
