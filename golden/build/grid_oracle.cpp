// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/build/grid_oracle.h"

#include <algorithm>
#include <cmath>

namespace cbvh::golden {
namespace {

constexpr int kMostAlongAnAxis = 64;

/// One axis' cells when the longest has `longest`.
int cells_along(double extent, double longest_extent, double longest) {
  const double share = longest_extent > 0 ? extent / longest_extent : 0;
  return std::clamp(static_cast<int>(std::min(share * longest, double{kMostAlongAnAxis})), 1, kMostAlongAnAxis);
}

}  // namespace

GridOracle::GridOracle(const Box& node, double cells) {
  std::array<double, 3> extent{};
  for (int axis = 0; axis < 3; ++axis)
    extent[static_cast<std::size_t>(axis)] =
        static_cast<double>(node.upper[axis]) - static_cast<double>(node.lower[axis]);
  const double longest_extent = *std::max_element(extent.begin(), extent.end());
  const auto resolution = [&](double longest) {
    std::array<int, 3> result{};
    for (std::size_t axis = 0; axis < 3; ++axis) result[axis] = cells_along(extent[axis], longest_extent, longest);
    return result;
  };
  double fits = 1;
  double too_many = kMostAlongAnAxis + 1;
  for (int step = 0; step < 40; ++step) {
    const double longest = (fits + too_many) / 2;
    const std::array<int, 3> tried = resolution(longest);
    (double{1} * tried[0] * tried[1] * tried[2] <= cells ? fits : too_many) = longest;
  }
  resolution_ = resolution(fits);
  for (int axis = 0; axis < 3; ++axis) axes_[static_cast<std::size_t>(axis)] = intervals(node, axis);
}

std::vector<GridOracle::Intervals> GridOracle::intervals(const Box& node, int axis) const {
  const int count = resolution_[static_cast<std::size_t>(axis)];
  const auto lower = static_cast<double>(node.lower[axis]);
  const double extent = static_cast<double>(node.upper[axis]) - lower;
  const auto plane = [&](int i) {
    if (i == 0 || i == count) return i == 0 ? node.lower[axis] : node.upper[axis];
    return std::clamp(static_cast<float>(lower + extent * i / count), node.lower[axis], node.upper[axis]);
  };
  std::vector<Intervals> all;
  const auto add = [&](int a, int b, int c, int d) {
    // Exchanged boxes are the same configuration: on the first axis the box that starts, then ends, first is the first.
    if (axis == 0 && (c < a || (c == a && d < b))) return;
    all.push_back({{plane(a), plane(b)}, {plane(c), plane(d)}});
  };
  for (int a = 0; a < count; ++a) {
    for (int b = a + 1; b <= count; ++b) {
      for (int c = 0; c < (a == 0 ? count : 1); ++c) {
        for (int d = b == count ? c + 1 : count; d <= count; ++d) add(a, b, c, d);
      }
    }
  }
  return all;
}

void GridOracle::keep(const std::function<bool(int axis, const Intervals&)>& will_do) {
  for (int axis = 0; axis < 3; ++axis)
    std::erase_if(axes_[static_cast<std::size_t>(axis)], [&](const Intervals& tried) { return !will_do(axis, tried); });
}

void GridOracle::for_each(const std::function<void(const std::array<Box, 2>&)>& visit) const {
  const auto set = [](std::array<Box, 2>& boxes, int axis, const Intervals& intervals) {
    boxes[0].lower[axis] = intervals.first[0];
    boxes[0].upper[axis] = intervals.first[1];
    boxes[1].lower[axis] = intervals.second[0];
    boxes[1].upper[axis] = intervals.second[1];
  };
  std::array<Box, 2> boxes{};
  for (const Intervals& x : axes_[0]) {
    set(boxes, 0, x);
    for (const Intervals& y : axes_[1]) {
      set(boxes, 1, y);
      for (const Intervals& z : axes_[2]) {
        set(boxes, 2, z);
        visit(boxes);
      }
    }
  }
}

}  // namespace cbvh::golden
