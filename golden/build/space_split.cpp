// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/build/space_split.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "golden/build/clip.h"
#include "golden/build/node_tree.h"
#include "golden/build/object_median.h"
#include "golden/build/wide_box.h"
#include "golden/input_error.h"

namespace cbvh::golden {
namespace {

struct Part {
  std::vector<Piece> pieces;
  Box cell;
  std::uint64_t allowance;  ///< references that all leaves below may have
};

Box box_of(const std::vector<Piece>& pieces) {
  Box box = pieces.front().box;
  for (const Piece& piece : pieces) box = unite(box, piece.box);
  return box;
}

float centroid(const Box& box, int axis) { return box.lower[axis] * 0.5F + box.upper[axis] * 0.5F; }

class SpaceBuild {
 public:
  SpaceBuild(const Mesh& of, const BuildLimits& within, const SpaceRules& by) : mesh(of), limits(within), rules(by) {
    const std::vector<Box> boxes = triangle_boxes(mesh);
    Part root{{}, {}, rules.references};
    for (std::uint32_t id = 0; id < boxes.size(); ++id) root.pieces.push_back({boxes[id], id});
    root.cell = box_of(root.pieces);
    tree_.nodes.emplace_back();
    build(std::move(root), 0, limits.depth);
  }

  const NodeTree& tree() const { return tree_; }

 private:
  void build(Part part, std::uint32_t node, int levels) {
    std::array<Part, 2> halves;
    do {
      if (rules.tight) part.cell = box_of(part.pieces);
      if (!divide(part, levels, halves)) return make_leaf(part.pieces, node);
      const bool left_empty = halves[0].pieces.empty();
      if (!left_empty && !halves[1].pieces.empty()) break;
      part = std::move(halves[left_empty ? 1 : 0]);  // a k-d tree's empty leaf: left out
    } while (true);
    part = {};
    const auto first = static_cast<std::uint32_t>(tree_.nodes.size());
    tree_.nodes.resize(tree_.nodes.size() + 2);
    tree_.nodes[node] = {{}, first, 0};
    build(std::move(halves[0]), first, levels - 1);
    build(std::move(halves[1]), first + 1, levels - 1);
  }

  /// False if the part had better be a leaf.
  bool divide(const Part& part, int levels, std::array<Part, 2>& halves) {
    const auto count = static_cast<std::uint32_t>(part.pieces.size());
    const double area = half_area(part.cell);
    if (limits.prefer_leaf(count, levels, area, 0)) return false;
    Split objects;
    if (rules.objects) objects = best_centroid(part);
    const double replaced = rules.objects && objects.exists() ? objects.cost : area * count;
    PlaneSplit plane;
    if (area > 0)
      plane =
          rules.exact_costs ? best_plane_exactly(part.pieces, mesh) : best_plane(part.pieces, part.cell, !rules.tight);
    const bool use_plane = plane.exists() && std::uint64_t{plane.left} + plane.right <= part.allowance &&
                           limits.fit(plane.left, plane.right, levels) && plane.cost <= (1 - rules.gain) * replaced;
    if (!use_plane && !rules.objects && count > limits.leaf) objects = best_centroid(part);
    if (limits.prefer_leaf(count, levels, area, use_plane ? plane.cost : objects.cost)) return false;
    if (use_plane) {
      divide_space(part, plane, halves);
    } else {
      divide_objects(part, objects, levels, area, halves);
    }
    const std::uint64_t left = halves[0].pieces.size();
    const std::uint64_t right = halves[1].pieces.size();
    const std::uint64_t surplus = part.allowance - left - right;
    halves[0].allowance = left + surplus * left / (left + right);
    halves[1].allowance = part.allowance - halves[0].allowance;
    return true;
  }

  void divide_space(const Part& part, const PlaneSplit& split, std::array<Part, 2>& halves) {
    halves = {Part{{}, below(part.cell, split.axis, split.plane), 0},
              Part{{}, above(part.cell, split.axis, split.plane), 0}};
    for (const Piece& piece : part.pieces) {
      const bool left = split.goes_left(piece.box);
      if (!left || !split.goes_right(piece.box)) {
        halves[left ? 0 : 1].pieces.push_back(piece);
        continue;
      }
      const glm::uvec3& t = mesh.triangles[piece.id];
      const Corners corners{mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z]};
      const auto low = clipped_box(corners, below(piece.box, split.axis, split.plane));
      const auto high = clipped_box(corners, above(piece.box, split.axis, split.plane));
      if (low) halves[0].pieces.push_back({*low, piece.id});
      if (high) halves[1].pieces.push_back({*high, piece.id});
      if (!low && !high) halves[0].pieces.push_back(piece);  // rounding had kept it: nothing of it is here
    }
  }

  /// Each centroid of each axis; of equal costs the lowest axis, then position.
  Split best_centroid(const Part& part) const {
    Split best;
    const auto count = static_cast<std::uint32_t>(part.pieces.size());
    std::vector<double> right_cost(count);
    for (int axis = 0; axis < 3; ++axis) {
      const std::vector<Rank> order = ranks(part, axis);
      WideBox box;
      for (std::uint32_t i = count - 1; i > 0; --i) {
        box.enclose(widened(part.pieces[order[i].index].box));
        right_cost[i] = half_area(box) * (count - i);
      }
      box = {};
      for (std::uint32_t i = 1; i < count; ++i) {
        box.enclose(widened(part.pieces[order[i - 1].index].box));
        const double cost = half_area(box) * i + right_cost[i];
        if (cost < best.cost) best = {cost, axis, i, i};
      }
    }
    return best;
  }

  static std::vector<Rank> ranks(const Part& part, int axis) {
    std::vector<Rank> order;
    for (const Piece& piece : part.pieces)
      order.push_back({centroid(piece.box, axis), static_cast<std::uint32_t>(order.size())});
    std::sort(order.begin(), order.end());
    return order;
  }

  void divide_objects(const Part& part, Split split, int levels, double area, std::array<Part, 2>& halves) const {
    const auto count = static_cast<std::uint32_t>(part.pieces.size());
    if (!limits.usable(split, area, count, levels)) {
      WideBox centroids;
      for (const Piece& piece : part.pieces) centroids.enclose(widened(piece.box).centroid());
      split = {0, longest_axis(centroids), count / 2, count / 2};
    }
    halves = {Part{{}, part.cell, 0}, Part{{}, part.cell, 0}};
    const std::vector<Rank> order = ranks(part, split.axis);
    for (std::uint32_t i = 0; i < count; ++i)
      halves[i < split.left ? 0 : 1].pieces.push_back(part.pieces[order[i].index]);
  }

  void make_leaf(const std::vector<Piece>& pieces, std::uint32_t node) {
    const auto first = tree_.references.size();
    for (const Piece& piece : pieces) tree_.references.push_back(piece.id);
    std::sort(tree_.references.begin() + static_cast<std::ptrdiff_t>(first), tree_.references.end());
    tree_.nodes[node] = {box_of(pieces), static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(pieces.size())};
  }

  const Mesh& mesh;
  const BuildLimits limits;
  const SpaceRules rules;
  NodeTree tree_;
};

}  // namespace

FloatTree build_by_space(const Mesh& mesh, const BuildLimits& limits, const SpaceRules& rules) {
  if (mesh.triangles.size() > rules.references) {
    throw InputError(mesh.name, fmt::format("{} triangles, but at most {} references are allowed",
                                            mesh.triangles.size(), rules.references));
  }
  return emit(SpaceBuild(mesh, limits, rules).tree(), mesh.triangles.size(), mesh.name);
}

Option references_option() {
  return {"references", "most references to triangles in leaves", static_cast<double>(kMaxCount), 1,
          static_cast<double>(kMaxCount)};
}

}  // namespace cbvh::golden
