// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/build/sweep.h"

#include <algorithm>
#include <array>
#include <utility>

#include "golden/build/radix_order.h"
#include "golden/build/sah_bins.h"

namespace cbvh::golden {
namespace {

/// A node to build: entries [first, first + count) of all three orders. Its descendants' nodes start at `below`; it has
/// room for 2 count - 2 of them.
struct Range {
  std::uint32_t first;
  std::uint32_t count;
  std::uint32_t node;
  std::uint32_t below;
  int levels;
};

class SweepBuild {
 public:
  SweepBuild(const std::vector<Box>& boxes, const BuildLimits& limits, SweepSort sort)
      : limits_(limits), sort_(sort), right_cost_(boxes.size()), is_left_(boxes.size()), moved_(boxes.size()) {
    const auto count = static_cast<std::uint32_t>(boxes.size());
    boxes_.reserve(count);
    for (const Box& box : boxes) boxes_.push_back(widened(box));
    std::vector<float> keys(count);
    for (int axis = 0; axis < 3; ++axis) {
      for (std::uint32_t id = 0; id < count; ++id) keys[id] = centroid(id, axis);
      orders_[static_cast<std::size_t>(axis)] = radix_order(keys);
    }
    tree_.nodes.resize(2 * std::size_t{count} - 1);
    tree_.references.resize(count);
    build({0, count, 0, 1, limits.depth});
  }

  NodeTree take() && { return std::move(tree_); }

 private:
  float centroid(std::uint32_t id, int axis) const { return boxes_[id].centroid()[axis]; }

  /// At most 64 deep.
  void build(const Range& node) {
    WideBox box;
    for (std::uint32_t i = 0; i < node.count; ++i) box.enclose(boxes_[orders_[0][node.first + i]]);
    const double area = half_area(box);
    if (limits_.prefer_leaf(node.count, node.levels, area, 0)) return make_leaf(node, box);
    if (sort_ == SweepSort::in_nodes) sort(node);
    Split split = best_split(node);
    if (limits_.prefer_leaf(node.count, node.levels, area, split.cost)) return make_leaf(node, box);
    if (!limits_.usable(split, area, node.count, node.levels)) split = median(node);
    tree_.nodes[node.node] = {{}, node.below, 0};
    partition(node, split);
    build({node.first, split.left, node.below, node.below + 2, node.levels - 1});
    build({node.first + split.left, node.count - split.left, node.below + 1, node.below + 2 * split.left,
           node.levels - 1});
  }

  void sort(const Range& node) {
    for (int axis = 0; axis < 3; ++axis) {
      const auto first = orders_[static_cast<std::size_t>(axis)].begin() + node.first;
      std::sort(first, first + node.count, [&](std::uint32_t a, std::uint32_t b) {
        const float left = centroid(a, axis);
        const float right = centroid(b, axis);
        return left < right || (left == right && a < b);
      });
    }
  }

  /// Every position of every axis. `node` has at least two triangles.
  Split best_split(const Range& node) {
    Split best;
    double* const right_cost = right_cost_.data() + node.first;
    for (int axis = 0; axis < 3; ++axis) {
      const std::uint32_t* const order = orders_[static_cast<std::size_t>(axis)].data() + node.first;
      WideBox box;
      for (std::uint32_t i = node.count - 1; i > 0; --i) {
        box.enclose(boxes_[order[i]]);
        right_cost[i] = half_area(box) * (node.count - i);
      }
      box = {};
      for (std::uint32_t i = 1; i < node.count; ++i) {
        box.enclose(boxes_[order[i - 1]]);
        const double cost = half_area(box) * i + right_cost[i];
        if (cost < best.cost) best = {cost, axis, i, i};
      }
    }
    return best;
  }

  /// The object median along the longest axis of the centroids.
  Split median(const Range& node) const {
    WideBox centroids;
    for (int axis = 0; axis < 3; ++axis) {
      const std::uint32_t* const order = orders_[static_cast<std::size_t>(axis)].data() + node.first;
      centroids.lower[axis] = centroid(order[0], axis);
      centroids.upper[axis] = centroid(order[node.count - 1], axis);
    }
    return {0, longest_axis(centroids), node.count / 2, node.count / 2};
  }

  /// Moves those left of the split to the front of all orders; each side keeps its order, or takes the split axis'.
  void partition(const Range& node, const Split& split) {
    const auto split_axis = static_cast<std::size_t>(split.axis);
    if (sort_ == SweepSort::in_nodes) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        if (axis == split_axis) continue;
        std::copy_n(orders_[split_axis].begin() + node.first, node.count, orders_[axis].begin() + node.first);
      }
      return;
    }
    for (std::uint32_t i = 0; i < node.count; ++i) is_left_[orders_[split_axis][node.first + i]] = i < split.left;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (axis == split_axis) continue;
      std::uint32_t* const order = orders_[axis].data() + node.first;
      std::uint32_t* const right = moved_.data() + node.first;
      std::uint32_t lefts = 0;
      for (std::uint32_t i = 0; i < node.count; ++i) {
        const std::uint32_t id = order[i];
        order[lefts] = id;  // at or before i; overwritten by the next one if this one is right
        right[i - lefts] = id;
        lefts += is_left_[id];
      }
      std::copy_n(right, node.count - split.left, order + split.left);
    }
  }

  void make_leaf(const Range& node, const WideBox& box) {
    tree_.nodes[node.node] = {narrowed(box), node.first, node.count};
    const auto from = orders_[0].begin() + node.first;
    const auto to = tree_.references.begin() + node.first;
    std::sort(to, std::copy_n(from, node.count, to));
  }

  BuildLimits limits_;
  SweepSort sort_;
  std::vector<WideBox> boxes_;                        ///< by triangle
  std::array<std::vector<std::uint32_t>, 3> orders_;  ///< triangles by centroid; equal ones in input order
  std::vector<double> right_cost_;                    ///< half area times count of those at the entry and behind
  std::vector<std::uint8_t> is_left_;                 ///< by triangle
  std::vector<std::uint32_t> moved_;
  NodeTree tree_;
};

FloatTree build(const Mesh& mesh, const OptionValues& options) {
  const std::vector<Box> boxes = triangle_boxes(mesh);
  const BuildLimits limits = build_limits(options, boxes.size(), mesh.name);
  const auto sort = options.word("sort") == 1 ? SweepSort::in_nodes : SweepSort::once;
  return emit(sweep_tree(boxes, limits, sort), boxes.size(), mesh.name);
}

std::vector<Option> sweep_options() {
  std::vector<Option> options = limit_options();
  options.push_back(
      word_option("sort", "centroids: once, or anew in every node; the tree is the same", {"once", "node"}));
  return options;
}

}  // namespace

NodeTree sweep_tree(const std::vector<Box>& boxes, const BuildLimits& limits, SweepSort sort) {
  return SweepBuild(boxes, limits, sort).take();
}

BuilderKind sweep_builder() {
  return {"sweep", "SAH at every centroid of three axes (Wald, Ize, Parker, what section 4 compares with)",
          sweep_options(), build};
}

}  // namespace cbvh::golden
