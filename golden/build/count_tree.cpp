// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/build/count_tree.h"

#include <algorithm>
#include <glm/vector_relational.hpp>

#include "golden/build/middle_split.h"

namespace cbvh::golden {
namespace {

constexpr std::uint32_t kLeaf = 4;
constexpr double kRoundedDown = 1 - 0x1p-50;  ///< more than sums of five terms are off
constexpr int kLevels = 48;                   ///< clusters that need more are leaves

bool holds(const Box& outer, const Box& inner) {
  return glm::all(glm::lessThanEqual(outer.lower, inner.lower)) &&
         glm::all(glm::lessThanEqual(inner.upper, outer.upper));
}

bool apart(const Box& a, const Box& b) {
  return glm::any(glm::lessThan(a.upper, b.lower)) || glm::any(glm::lessThan(b.upper, a.lower));
}

/// Whether what of a piece lies outside of `box` lies in `other`: its parts beyond each side do.
bool rest_is_in(const Piece& piece, const Mesh& mesh, const Box& box, const Box& other) {
  const Corners corners = corners_of(mesh, piece.id);
  const auto inside = [&](const std::optional<Box>& part) { return !part || holds(other, *part); };
  for (int axis = 0; axis < 3; ++axis) {
    if (piece.box.lower[axis] < box.lower[axis] &&
        !inside(clipped_box(corners, below(piece.box, axis, box.lower[axis]))))
      return false;
    if (piece.box.upper[axis] > box.upper[axis] &&
        !inside(clipped_box(corners, above(piece.box, axis, box.upper[axis]))))
      return false;
  }
  return true;
}

}  // namespace

std::optional<Side> SideRule::side_of_all(const Box& around) const {
  const Box& small = boxes_[smaller_];
  const Box& large = boxes_[1 - smaller_];
  if (holds(small, around)) return whole(smaller_);
  // A piece that touches a side of `around` is not in a box that ends before it.
  if (apart(small, around)) return holds(large, around) ? whole(1 - smaller_) : Side::nowhere;
  if (apart(large, around)) return Side::nowhere;
  return std::nullopt;
}

Side SideRule::side_of(const Piece& piece, const Mesh& mesh) const {
  if (const auto side = side_of_all(piece.box)) return *side;
  const std::size_t larger = 1 - smaller_;
  if (holds(boxes_[larger], piece.box)) return whole(larger);
  if (!may_split_) return Side::nowhere;
  return rest_is_in(piece, mesh, boxes_[smaller_], boxes_[larger]) ? Side::both : Side::nowhere;
}

CountTree::CountTree(std::span<const Piece> pieces, const Mesh& mesh)
    : mesh_(mesh), pieces_(pieces.begin(), pieces.end()) {
  build(0, static_cast<std::uint32_t>(pieces_.size()), kLevels);
}

void CountTree::build(std::uint32_t first, std::uint32_t count, int levels) {
  const auto node = static_cast<std::uint32_t>(nodes_.size());
  const std::span<Piece> here(pieces_.data() + first, count);
  nodes_.push_back({box_of(here), first, count, 0, true});
  std::uint32_t left = 0;
  if (count > kLeaf && levels > 0) left = split_in_middle(here);
  if (left > 0) {
    nodes_[node].leaf = false;
    build(first, left, levels - 1);
    build(first + left, count - left, levels - 1);
  }
  nodes_[node].next = static_cast<std::uint32_t>(nodes_.size());
}

bool CountTree::rejected_as_before(const SideRule& rule) {
  return std::any_of(rejecting_.begin(), rejecting_.end(),
                     [&](std::uint32_t i) { return rule.side_of(pieces_[i], mesh_) == Side::nowhere; });
}

bool CountTree::count(ChildBoxes& children, bool may_split, double most) {
  const SideRule rule(children.box, may_split);
  if (rejected_as_before(rule)) return false;
  const std::array<double, 2> area{half_area(children.box[0]), half_area(children.box[1])};
  const double least_area = area[rule.smaller()];
  std::array<std::uint32_t, 2>& counts = children.count;
  counts = {0, 0};
  auto left = static_cast<std::uint32_t>(pieces_.size());  // still to be counted
  for (std::uint32_t i = 0; i < nodes_.size();) {
    const Node& node = nodes_[i];
    if (const auto side = rule.side_of_all(node.box)) {
      if (*side == Side::nowhere) return false;
      counts[*side == Side::first ? 0 : 1] += node.count;
      left -= node.count;
      i = node.next;
    } else if (node.leaf) {
      for (std::uint32_t entry = node.first; entry < node.first + node.count; ++entry) {
        const Side of_one = rule.side_of(pieces_[entry], mesh_);
        if (of_one == Side::nowhere) {
          rejecting_[next_rejecting_++ % rejecting_.size()] = entry;
          return false;
        }
        counts[0] += of_one != Side::second ? 1 : 0;
        counts[1] += of_one != Side::first ? 1 : 0;
      }
      left -= node.count;
      i = node.next;
    } else {
      ++i;
      continue;
    }
    const double least = area[0] * counts[0] + area[1] * counts[1] + least_area * left;
    if (least * kRoundedDown >= most) return false;
  }
  return true;
}

}  // namespace cbvh::golden
