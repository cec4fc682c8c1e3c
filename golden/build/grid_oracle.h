// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "golden/quantize/grid.h"

namespace cbvh::golden {

/// Children's boxes with sides on a regular grid over a node (paper 001, section 3.3): at most `cells` cells, as many
/// on each axis as its extent asks for.
class GridOracle {
 public:
  GridOracle(const Box& node, double cells);

  const std::array<int, 3>& resolution() const { return resolution_; }

  /// The two boxes' intervals on an axis.
  struct Intervals {
    std::array<float, 2> first;
    std::array<float, 2> second;
  };
  /// Leaves out the boxes whose intervals on an axis will not do, whatever they are on the others.
  void keep(const std::function<bool(int axis, const Intervals&)>& will_do);

  /// Every pair of boxes that together reach all sides of the node, each once whichever box comes first.
  void for_each(const std::function<void(const std::array<Box, 2>&)>& visit) const;

 private:
  std::vector<Intervals> intervals(const Box& node, int axis) const;

  std::array<int, 3> resolution_{1, 1, 1};
  std::array<std::vector<Intervals>, 3> axes_;
};

}  // namespace cbvh::golden
