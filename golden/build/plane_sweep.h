// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <span>

#include "golden/build/piece.h"

namespace cbvh::golden {

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

/// Every plane at the pieces' boundaries with its cost: by axis, then plane, planar_left first. `cell` encloses the
/// pieces. Planes that leave a side without pieces count only if `empty_sides`.
void for_each_plane(std::span<const Piece> pieces, const Box& cell, bool empty_sides,
                    const std::function<void(const PlaneSplit&)>& visit);

/// The cheapest of them, the first of equals.
PlaneSplit best_plane(std::span<const Piece> pieces, const Box& cell, bool empty_sides);

/// The same, costs being those of the boxes around what either side would hold (section 5.2: two sweeps with a queue of
/// the pieces across the plane).
PlaneSplit best_plane_exactly(std::span<const Piece> pieces, const Mesh& mesh);

}  // namespace cbvh::golden
