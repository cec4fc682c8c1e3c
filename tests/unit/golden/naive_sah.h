// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <functional>
#include <limits>
#include <vector>

#include "golden/build/float_tree.h"

namespace cbvh::golden {

/// Top-down SAH builders from their definitions, quadratic: every split of a list of triangles tried on its own.
class NaiveSah {
 public:
  using Ids = std::vector<std::uint32_t>;  ///< in input order
  struct Halves {
    Ids left;
    Ids right;
  };
  /// All splits of a node that may be cheapest, in the order in which the first of equals wins.
  using Candidates = std::function<std::vector<Halves>(const NaiveSah&, const Ids&)>;

  std::size_t leaf = 4;
  int depth = 32;
  double traversal = 1;
  double intersection = 1;
  Candidates candidates;
  std::vector<Box> boxes;

  FloatTree build(const Mesh& mesh) {
    boxes = triangle_boxes(mesh);
    Ids all(boxes.size());
    for (std::uint32_t id = 0; id < all.size(); ++id) all[id] = id;
    FloatTree tree;
    node(all, depth, tree);
    tree.leaves = static_cast<std::uint32_t>(tree.pairs.size() + 1);
    return tree;
  }

  float centroid(std::uint32_t id, int axis) const {
    return boxes[id].lower[axis] * 0.5F + boxes[id].upper[axis] * 0.5F;
  }

  double area(const Ids& ids) const {
    Box box = boxes[ids[0]];
    for (const std::uint32_t id : ids) box = unite(box, boxes[id]);
    return half_area(box);
  }

  double cost(const Halves& halves) const {
    return area(halves.left) * static_cast<double>(halves.left.size()) +
           area(halves.right) * static_cast<double>(halves.right.size());
  }

  /// In the order of their centroids, equal ones in input order.
  Ids sorted(Ids ids, int axis) const {
    std::stable_sort(ids.begin(), ids.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return centroid(a, axis) < centroid(b, axis); });
    return ids;
  }

  /// The first `count` of a sorted list and the rest, both back in input order.
  static Halves cut(const Ids& ids, std::size_t count) {
    Halves halves{{ids.begin(), ids.begin() + static_cast<std::ptrdiff_t>(count)},
                  {ids.begin() + static_cast<std::ptrdiff_t>(count), ids.end()}};
    std::sort(halves.left.begin(), halves.left.end());
    std::sort(halves.right.begin(), halves.right.end());
    return halves;
  }

  /// Before every centroid but the first, axis after axis.
  static std::vector<Halves> positions(const NaiveSah& scene, const Ids& ids) {
    std::vector<Halves> all;
    for (int axis = 0; axis < 3; ++axis) {
      const Ids order = scene.sorted(ids, axis);
      for (std::size_t i = 1; i < order.size(); ++i) all.push_back(cut(order, i));
    }
    return all;
  }

 protected:
  struct Emitted {
    Box box;
    bool leaf;
    std::uint32_t pointer;
  };

  Halves median(const Ids& ids) const {
    int axis = 0;
    double longest = -1;
    for (int a = 0; a < 3; ++a) {
      const Ids order = sorted(ids, a);
      const double extent =
          static_cast<double>(centroid(order.back(), a)) - static_cast<double>(centroid(order.front(), a));
      if (extent > longest) {
        longest = extent;
        axis = a;
      }
    }
    return cut(sorted(ids, axis), ids.size() / 2);
  }

  static bool fits(std::size_t count, std::size_t leaf_size, int levels) {
    for (int i = 0; i < levels; ++i) count = (count + 1) / 2;
    return count <= leaf_size;
  }

  bool is_leaf(const Ids& ids, int levels, double split_cost) const {
    const double a = area(ids);
    return ids.size() <= leaf &&
           (ids.size() == 1 || levels == 0 ||
            intersection * static_cast<double>(ids.size()) * a <= traversal * a + intersection * split_cost);
  }

  Emitted emit_leaf(const Ids& ids, FloatTree& tree) const {
    Box box = boxes[ids[0]];
    for (const std::uint32_t id : ids) box = unite(box, boxes[id]);
    const auto first = static_cast<std::uint32_t>(tree.primitive_ids.size());
    tree.primitive_ids.insert(tree.primitive_ids.end(), ids.begin(), ids.end());
    tree.primitive_ids.back() |= kLastOfLeaf;
    return {box, true, first};
  }

  static Emitted emit_pair(const Emitted& left, const Emitted& right, FloatTree& tree) {
    tree.pairs.push_back({{left.box, right.box}, {left.leaf, right.leaf}, {left.pointer, right.pointer}});
    return {unite(left.box, right.box), false, static_cast<std::uint32_t>(tree.pairs.size() - 1)};
  }

 private:
  Emitted node(const Ids& ids, int levels, FloatTree& tree) const {
    double least = std::numeric_limits<double>::infinity();
    Halves best;
    for (const Halves& halves : candidates(*this, ids)) {
      if (cost(halves) < least) {
        least = cost(halves);
        best = halves;
      }
    }
    if (is_leaf(ids, levels, least)) return emit_leaf(ids, tree);
    const bool usable =
        area(ids) > 0 && !best.left.empty() && fits(std::max(best.left.size(), best.right.size()), leaf, levels - 1);
    if (!usable) best = median(ids);
    const Emitted left = node(best.left, levels - 1, tree);
    const Emitted right = node(best.right, levels - 1, tree);
    return emit_pair(left, right, tree);
  }
};

}  // namespace cbvh::golden
