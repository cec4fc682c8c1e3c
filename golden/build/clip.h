// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <optional>

#include "golden/quantize/grid.h"

namespace cbvh::golden {

using Corners = std::array<glm::vec3, 3>;

/// A binary32 box around every point of the triangle that lies in `within`, itself in `within` and in the triangle's
/// box; nothing where the triangle certainly misses `within`. Exact enough, never too small: clipped in binary64 with a
/// margin that outweighs its rounding, then rounded outwards (paper 001, section 4.1, figure 5 b).
std::optional<Box> clipped_box(const Corners& triangle, const Box& within);

/// The part of a box below, and above, a plane.
inline Box below(Box box, int axis, float plane) {
  box.upper[axis] = plane;
  return box;
}
inline Box above(Box box, int axis, float plane) {
  box.lower[axis] = plane;
  return box;
}

/// The greatest float that is not above x, and the least that is not below; |x| at most the greatest float's.
float rounded_down(double x);
float rounded_up(double x);

}  // namespace cbvh::golden
