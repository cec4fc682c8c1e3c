// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "golden/build/piece.h"

namespace cbvh::golden {

/// Two boxes for a node's children (paper 001, section 3.1), and how many pieces each gets.
struct ChildBoxes {
  std::array<Box, 2> box;
  std::array<std::uint32_t, 2> count{};
};

/// Where a piece goes, given the boxes (section 3.1): into the box that holds all of it, of both the one with less
/// area, of equal ones the first; into both boxes if it takes both to hold it and pieces may be split (section 4.1).
enum class Side : std::uint8_t { first, second, both, nowhere };

/// Where pieces go, for two boxes.
class SideRule {
 public:
  SideRule(const std::array<Box, 2>& boxes, bool may_split)
      : boxes_(boxes), smaller_(half_area(boxes[1]) < half_area(boxes[0]) ? 1 : 0), may_split_(may_split) {}

  Side side_of(const Piece& piece, const Mesh& mesh) const;
  /// The same for all pieces in their common box, which they touch on every side; nothing if they may differ.
  std::optional<Side> side_of_all(const Box& around) const;

  const std::array<Box, 2>& boxes() const { return boxes_; }
  std::size_t smaller() const { return smaller_; }

 private:
  Side whole(std::size_t box) const { return box == 0 ? Side::first : Side::second; }

  std::array<Box, 2> boxes_;
  std::size_t smaller_;
  bool may_split_;
};

/// The auxiliary BVH of section 3.2: counts what two boxes would hold without asking every piece. Split in the middle
/// of centroids, boxes tight.
class CountTree {
 public:
  CountTree(std::span<const Piece> pieces, const Mesh& mesh);

  /// Sets `children.count`, a piece across both counted twice. False if a piece has nowhere to go (section 3.2,
  /// "rejected") or if half area times count, of both, is certainly at least `most`.
  bool count(ChildBoxes& children, bool may_split, double most);

 private:
  struct Node {
    Box box;
    std::uint32_t first;  ///< piece
    std::uint32_t count;
    std::uint32_t next;  ///< the node behind all that lie below this one
    bool leaf;
  };

  void build(std::uint32_t first, std::uint32_t count, int levels);
  /// One of the pieces that had nowhere to go last still has not.
  bool rejected_as_before(const SideRule& rule);

  const Mesh& mesh_;
  std::vector<Piece> pieces_;
  std::vector<Node> nodes_;  ///< depth first
  std::array<std::uint32_t, 8> rejecting_{};
  std::size_t next_rejecting_ = 0;
};

}  // namespace cbvh::golden
