// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <span>

#include "golden/build/build_limits.h"
#include "golden/build/float_tree.h"

namespace cbvh::golden {

/// A triangle, or the part of it in a node: its ID and the box of that part.
struct Piece {
  Box box;
  std::uint32_t id;
};

/// A plane that splits a node's space. Pieces above or below it go to one side, pieces across it to both, pieces in it
/// to the side that says planar_left.
struct PlaneSplit {
  double cost = std::numeric_limits<double>::infinity();  ///< half area times count, of both sides
  int axis = 0;
  float plane = 0;
  bool planar_left = false;
  std::uint32_t left = 0;  ///< pieces
  std::uint32_t right = 0;

  bool exists() const { return left + right > 0; }
  bool goes_left(const Box& box) const { return box.lower[axis] < plane || (planar_left && box.upper[axis] == plane); }
  bool goes_right(const Box& box) const {
    return box.upper[axis] > plane || (!planar_left && box.lower[axis] == plane);
  }
};

/// What the builders of paper 001 that split triangles differ in.
struct SpaceRules {
  bool tight = true;     ///< a node's box is its pieces'; otherwise the cell that planes cut out, as in a k-d tree
  bool objects = false;  ///< also the best split by centroids, and the cheaper of both
  bool exact_costs =
      false;        ///< costs of the sides' tight boxes (section 5.2), not of what the plane leaves of the node
  double gain = 0;  ///< how much cheaper a plane has to be than what it replaces, as a fraction
  std::uint64_t references = kMaxCount;  ///< the most; never fewer than triangles
};

/// The cheapest plane among the pieces' boundaries, of equals the lowest axis, then plane, then planar_left first.
/// `cell` encloses the pieces. Planes that leave a side without pieces count only if `empty_sides`.
PlaneSplit best_plane(std::span<const Piece> pieces, const Box& cell, bool empty_sides);

/// The same, costs being those of the boxes around what either side would hold (section 5.2: two sweeps with a queue of
/// the pieces across the plane).
PlaneSplit best_plane_exactly(std::span<const Piece> pieces, const Mesh& mesh);

/// A tree by splitting space. A node whose best split does not fit the levels left, or the references it may still
/// add, is split by objects, at the cheapest centroid that fits, or at the object median. References
/// that may be added are shared among a node's halves in proportion to their pieces. A node that no split makes cheaper
/// is a leaf if it has at most `leaf` pieces.
FloatTree build_by_space(const Mesh& mesh, const BuildLimits& limits, const SpaceRules& rules);

/// `references`, the most references in leaves.
Option references_option();

}  // namespace cbvh::golden
