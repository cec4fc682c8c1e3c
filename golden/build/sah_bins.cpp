// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/build/sah_bins.h"

#include <algorithm>
#include <limits>

namespace cbvh::golden {

BinMapping::BinMapping(const WideBox& centroids, const std::array<int, 3>& bins)
    : lower_(centroids.lower), scale_{}, last_{} {
  constexpr double kGreatest = std::numeric_limits<float>::max();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double extent = static_cast<double>(centroids.upper[axis]) - static_cast<double>(centroids.lower[axis]);
    if (extent > 0) scale_[axis] = static_cast<float>(std::min(bins[axis] / extent, kGreatest));
    last_[axis] = static_cast<float>(bins[axis] - 1);
  }
}

void SahBins::merge(const SahBins& other) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(bins_); ++i) {
      const Bin& theirs = other.axes_[axis][i];
      axes_[axis][i].add(theirs.box(), theirs.weight);
    }
  }
}

std::uint32_t SahBins::left(const Split& split) const {
  std::uint32_t weight = 0;
  for (std::size_t i = 0; i < split.position; ++i) weight += axes_[static_cast<std::size_t>(split.axis)][i].weight;
  return weight;
}

std::array<WideBox, 2> SahBins::boxes(const Split& split) const {
  const auto& bins = axes_[static_cast<std::size_t>(split.axis)];
  std::array<WideBox, 2> boxes;
  for (std::size_t i = 0; i < static_cast<std::size_t>(bins_); ++i)
    boxes[i < split.position ? 0 : 1].enclose(bins[i].box());
  return boxes;
}

Split SahBins::best() const {
  Split best;
  const auto bins = static_cast<std::size_t>(bins_);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto& entries = axes_[axis];
    std::array<double, kMaxBins> right_cost;  // of the bins from i on
    WideBox box;
    std::uint32_t weight = 0;
    double cost_so_far = 0;
    for (std::size_t i = bins; --i > 0;) {
      if (entries[i].weight > 0) {
        box.enclose(entries[i].box());
        weight += entries[i].weight;
        cost_so_far = half_area(box) * weight;
      }
      right_cost[i] = cost_so_far;
    }
    const std::uint32_t total = weight + entries[0].weight;
    box = {};
    weight = 0;
    for (std::size_t i = 1; i < bins; ++i) {
      if (entries[i - 1].weight == 0) continue;  // nothing to the left, or the same split as one before
      box.enclose(entries[i - 1].box());
      weight += entries[i - 1].weight;
      if (weight == total) break;
      const double cost = half_area(box) * weight + right_cost[i];
      if (cost < best.cost) best = {cost, static_cast<int>(axis), static_cast<std::uint32_t>(i), weight};
    }
  }
  return best;
}

}  // namespace cbvh::golden
