// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/build/small_sweep.h"

namespace cbvh::golden {

SmallSweep::SmallSweep(std::span<const Reference> references) {
  const std::size_t count = references.size();
  std::array<Float4, kMost> centroids;
  for (std::size_t i = 0; i < count; ++i) {
    // A rank counts those before: all three axes at once, each pair once.
    const Float4 centroid = references[i].box().centroid();
    Int4 rank{};
    for (std::size_t j = 0; j < i; ++j) {
      const Int4 behind = centroid < centroids[j];  // -1 where i comes before j
      ranks_[j] -= behind;
      rank += behind + 1;
    }
    centroids[i] = centroid;
    ranks_[i] = rank;
  }
  const int axes = count == 2 ? 1 : 3;  // two boxes cost the same in either order
  for (int axis = 0; axis < axes; ++axis) {
    std::array<const WideBox*, kMost> order;  // as many as there are references
    for (std::size_t i = 0; i < count; ++i) order[static_cast<std::size_t>(ranks_[i][axis])] = &references[i].box();
    std::array<double, kMost> right_cost;
    WideBox box;
    for (std::size_t i = count - 1; i > 0; --i) {
      box.enclose(*order[i]);
      right_cost[i] = half_area(box) * static_cast<double>(count - i);
    }
    box = {};
    for (std::size_t i = 1; i < count; ++i) {
      box.enclose(*order[i - 1]);
      const double cost = half_area(box) * static_cast<double>(i) + right_cost[i];
      if (cost < best_.cost) best_ = {cost, axis, static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(i)};
    }
  }
}

}  // namespace cbvh::golden
