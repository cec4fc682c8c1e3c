// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/build/two_level/opening_rule.h"

#include <algorithm>

namespace cbvh::golden {
namespace {

double extent_of(const WideBox& box, int axis) {
  return static_cast<double>(box.upper[axis]) - static_cast<double>(box.lower[axis]);
}

/// What two boxes share; boxes that only touch share nothing, flat ones in one plane do.
bool share(const WideBox& a, const WideBox& b, WideBox& shared) {
  shared = {greater(a.lower, b.lower), lesser(a.upper, b.upper)};
  for (int axis = 0; axis < 3; ++axis) {
    const double extent = extent_of(shared, axis);
    if (extent < 0 || (extent == 0 && extent_of(a, axis) > 0 && extent_of(b, axis) > 0)) return false;
  }
  return true;
}

bool meets_another(std::span<const BuildReference> segment, const BuildReference& reference) {
  WideBox shared;
  return std::any_of(segment.begin(), segment.end(), [&](const BuildReference& other) {
    return other.to.instance != reference.to.instance && share(other.bounds, reference.bounds, shared);
  });
}

}  // namespace

bool OpeningRule::ends(std::span<const BuildReference> segment, const WideBox& bounds) const {
  const auto of_first = [&](const BuildReference& r) { return r.to.instance == segment.front().to.instance; };
  if (std::all_of(segment.begin(), segment.end(), of_first)) return true;
  if (segment.size() > 4) return false;
  double sum = 0;
  WideBox shared;
  for (std::size_t i = 0; i < segment.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (segment[i].to.instance != segment[j].to.instance && share(segment[i].bounds, segment[j].bounds, shared))
        sum += half_area(shared);
    }
  }
  return sum <= overlap * half_area(bounds);
}

double OpeningRule::least_extent(const WideBox& bounds, int axis) const { return extent * extent_of(bounds, axis); }

void OpeningRule::choose(std::span<const BuildReference> segment, const WideBox& bounds, const Opener& opener,
                         std::vector<std::uint32_t>& chosen) const {
  chosen.clear();
  const int axis = longest_axis(bounds);
  const double least = least_extent(bounds, axis);
  const bool look = order == Order::overlap && segment.size() <= kWindow;
  for (std::uint32_t i = 0; i < segment.size(); ++i) {
    const BuildReference& reference = segment[i];
    if (!opener.can_open(reference) || !(extent_of(reference.bounds, axis) > least)) continue;
    if (!look || meets_another(segment, reference)) chosen.push_back(i);
  }
  if (order == Order::cost) {
    const auto cost = [&](std::uint32_t i) { return half_area(segment[i].bounds) * segment[i].primitives; };
    std::sort(chosen.begin(), chosen.end(),
              [&](std::uint32_t a, std::uint32_t b) { return cost(a) > cost(b) || (cost(a) == cost(b) && a < b); });
  }
}

std::uint32_t OpeningRule::candidates(std::span<const BuildReference> segment, const WideBox& bounds,
                                      const Opener& opener) const {
  const int axis = longest_axis(bounds);
  const double least = least_extent(bounds, axis);
  return static_cast<std::uint32_t>(std::count_if(segment.begin(), segment.end(), [&](const BuildReference& r) {
    return opener.can_open(r) && extent_of(r.bounds, axis) > least;
  }));
}

}  // namespace cbvh::golden
