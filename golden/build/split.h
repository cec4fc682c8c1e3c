// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>

namespace cbvh::golden {

/// A way to split a node in two: those before `position` on the axis, and the others.
struct Split {
  double cost = std::numeric_limits<double>::infinity();  ///< half area times count, of both sides; no split: infinite
  int axis = 0;
  std::uint32_t position = 0;  ///< in bins, or in the order of centroids
  std::uint32_t left = 0;      ///< weight before the position

  bool exists() const { return position > 0; }
};

}  // namespace cbvh::golden
