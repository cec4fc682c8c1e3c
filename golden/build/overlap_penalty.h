// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/common.hpp>

#include "golden/quantize/grid.h"

namespace cbvh::golden {

/// In binary64; 0 of a box that is none.
inline double volume(const Box& box) {
  double product = 1;
  for (int axis = 0; axis < 3; ++axis) {
    const double extent = static_cast<double>(box.upper[axis]) - static_cast<double>(box.lower[axis]);
    if (extent <= 0) return 0;
    product *= extent;
  }
  return product;
}

/// The penalty on children that overlap (paper 001, equation 5): their cost counts 1 + C_O V(left and right) / V(node)
/// times. A node without volume has none.
class OverlapPenalty {
 public:
  OverlapPenalty(double weight, const Box& node)
      : weight_(weight > 0 && volume(node) > 0 ? weight / volume(node) : 0) {}

  double factor(const Box& left, const Box& right) const {
    if (weight_ == 0) return 1;
    return 1 + weight_ * volume({glm::max(left.lower, right.lower), glm::min(left.upper, right.upper)});
  }

 private:
  double weight_;  ///< C_O / V(node)
};

}  // namespace cbvh::golden
