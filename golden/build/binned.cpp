// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/build/binned.h"

#include <array>
#include <span>

#include "golden/build/build_limits.h"
#include "golden/build/node_tree.h"
#include "golden/build/object_median.h"
#include "golden/build/sah_bins.h"
#include "golden/build/small_sweep.h"

namespace cbvh::golden {
namespace {

/// A node to build: references [first, first + count) of buffer `side`. Its descendants' nodes start at `below`; it
/// has room for 2 count - 2 of them.
struct Range {
  std::uint32_t first;
  std::uint32_t count;
  std::uint32_t node;
  std::uint32_t below;
  int levels;
  bool side;
  WideBox box;
};

class BinnedBuild {
 public:
  BinnedBuild(const std::vector<Box>& boxes, const BuildLimits& limits, int bins) : limits_(limits), bins_(bins) {
    const auto count = static_cast<std::uint32_t>(boxes.size());
    for (auto& buffer : buffers_) buffer.resize(count);
    WideBox scene;
    for (std::uint32_t id = 0; id < count; ++id) {
      buffers_[0][id] = Reference(boxes[id], id);
      scene.enclose(buffers_[0][id].box());
    }
    tree_.nodes.resize(2 * std::size_t{count} - 1);
    tree_.references.resize(count);
    build({0, count, 0, 1, limits.depth, false, scene});
  }

  const NodeTree& tree() const { return tree_; }

 private:
  /// At most 64 deep.
  void build(const Range& node) {
    const std::span<const Reference> references(buffers_[node.side].data() + node.first, node.count);
    const double area = half_area(node.box);
    if (limits_.prefer_leaf(node.count, node.levels, area, 0)) return make_leaf(node);

    if (node.count <= static_cast<std::uint32_t>(bins_)) {
      const SmallSweep sweep(references);
      if (limits_.prefer_leaf(node.count, node.levels, area, sweep.best().cost)) return make_leaf(node);
      if (is_usable(sweep.best(), node, area)) {
        divide(node, sweep.best().left, [&](std::uint32_t i, const Reference&) { return sweep.is_left(i); });
      } else {
        divide_at_median(node, references);
      }
      return;
    }
    const BinMapping mapping(centroids_of(references), bins_);
    SahBins bins(bins_);
    for (const Reference& reference : references)
      bins.add(mapping.bin_of(reference.box().centroid()), reference.box(), 1);
    const Split split = bins.best();
    if (limits_.prefer_leaf(node.count, node.levels, area, split.cost)) return make_leaf(node);
    if (is_usable(split, node, area)) {
      const auto position = static_cast<std::int32_t>(split.position);
      divide(node, split.left, [&](std::uint32_t, const Reference& reference) {
        return mapping.bin_of(reference.box().centroid())[split.axis] < position;
      });
    } else {
      divide_at_median(node, references);
    }
  }

  static WideBox centroids_of(std::span<const Reference> references) {
    WideBox centroids;
    for (const Reference& reference : references) centroids.enclose(reference.box().centroid());
    return centroids;
  }

  bool is_usable(const Split& split, const Range& node, double area) const {
    return area > 0 && split.exists() && limits_.fit(split.left, node.count - split.left, node.levels);
  }

  void divide_at_median(const Range& node, std::span<const Reference> references) {
    const int axis = longest_axis(centroids_of(references));
    const auto key = [axis](const Reference& reference) {
      return static_cast<float>(reference.box().centroid()[axis]);
    };
    const Rank median = object_median(node.count, [&](std::uint32_t i) { return key(references[i]); });
    divide(node, node.count / 2, [&](std::uint32_t i, const Reference& reference) {
      return Rank{key(reference), i} < median;
    });
  }

  /// Moves `left` references of which is_left(index, reference) holds to the front of the other buffer, the others
  /// behind them, in their order, and builds both halves.
  template <class IsLeft>
  void divide(const Range& node, std::uint32_t left, const IsLeft& is_left) {
    const Reference* from = buffers_[node.side].data() + node.first;
    Reference* to = buffers_[!node.side].data() + node.first;
    std::array<WideBox, 2> boxes;
    std::array<std::uint32_t, 2> next{0, left};
    for (std::uint32_t i = 0; i < node.count; ++i) {
      const std::size_t half = is_left(i, from[i]) ? 0 : 1;
      to[next[half]++] = from[i];
      boxes[half].enclose(from[i].box());
    }
    tree_.nodes[node.node] = {{}, node.below, 0};
    build({node.first, left, node.below, node.below + 2, node.levels - 1, !node.side, boxes[0]});
    build({node.first + left, node.count - left, node.below + 1, node.below + 2 * left, node.levels - 1, !node.side,
           boxes[1]});
  }

  void make_leaf(const Range& node) {
    tree_.nodes[node.node] = {narrowed(node.box), node.first, node.count};
    const Reference* from = buffers_[node.side].data();
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) tree_.references[i] = from[i].id();
  }

  BuildLimits limits_;
  int bins_;
  std::array<std::vector<Reference>, 2> buffers_;
  NodeTree tree_;
};

FloatTree build(const Mesh& mesh, const OptionValues& options) {
  const std::vector<Box> boxes = triangle_boxes(mesh);
  const BuildLimits limits = build_limits(options, boxes.size(), mesh.name);
  return emit(BinnedBuild(boxes, limits, static_cast<int>(options.integer("bins"))).tree(), boxes.size(), mesh.name);
}

}  // namespace

BuilderKind binned_builder() {
  std::vector<Option> options = limit_options();
  options.insert(options.begin(), {"bins", "bins an axis", 16, 4, kMaxBins});
  return {"binned", "SAH between bins of centroids, on three axes (Wald, Ize, Parker, section 4)", std::move(options),
          build};
}

}  // namespace cbvh::golden
