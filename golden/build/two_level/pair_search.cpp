// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/build/two_level/pair_search.h"

#include <algorithm>
#include <array>
#include <bit>
#include <glm/common.hpp>
#include <limits>
#include <numeric>

namespace cbvh::golden {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// What a box around nothing is to TreeSearch: together with any box it is infinite.
WideBox nothing() {
  constexpr float kFar = std::numeric_limits<float>::infinity();
  return {Float4{} - kFar, Float4{} + kFar};
}

bool is_nothing(const WideBox& box) { return box.lower[0] == -std::numeric_limits<float>::infinity(); }

/// What is above two nodes: the largest lower, the smallest upper corner of what is left below.
WideBox above(const WideBox& a, const WideBox& b) {
  if (is_nothing(a)) return b;
  if (is_nothing(b)) return a;
  return {greater(a.lower, b.lower), lesser(a.upper, b.upper)};
}

WideBox around(WideBox a, const WideBox& b) {
  a.enclose(b);
  return a;
}

/// The distance of clustering: what has to be enclosed if two boxes are paired. Rounding is monotone, so with the
/// corners of a TreeSearch node it is a lower bound.
double distance(const WideBox& a, const WideBox& b) { return half_area(around(a, b)); }

}  // namespace

ScanSearch::ScanSearch(std::span<const Box> items) {
  boxes.reserve(items.size());
  for (const Box& box : items) boxes.push_back(widened(box));
}

std::uint32_t ScanSearch::best_match(std::uint32_t position) const {
  double smallest = kInfinity;
  std::uint32_t best = position;
  for (std::uint32_t other = 0; other < boxes.size(); ++other) {
    if (other == position) continue;
    const double d = distance(boxes[position], boxes[other]);
    if (d < smallest) {
      smallest = d;
      best = other;
    }
  }
  return best;
}

void ScanSearch::merge(std::uint32_t a, std::uint32_t b) {
  boxes[a].enclose(boxes[b]);
  boxes[b] = boxes.back();
  boxes.pop_back();
}

TreeSearch::TreeSearch(std::span<const Box> items) {
  first_place = std::bit_ceil(items.size());
  nodes.assign(2 * first_place, nothing());
  place_of.resize(items.size());
  position_of.resize(first_place);
  std::vector<std::uint32_t> order(items.size());
  std::iota(order.begin(), order.end(), 0);
  sort_places(order, 0, items, static_cast<std::uint32_t>(first_place));
  for (std::size_t position = 0; position < items.size(); ++position)
    nodes[first_place + place_of[position]] = widened(items[position]);
  for (std::size_t node = first_place - 1; node > 0; --node) nodes[node] = above(nodes[2 * node], nodes[2 * node + 1]);
}

/// Halves at the median of the centres on the axis where they spread most.
void TreeSearch::sort_places(std::span<std::uint32_t> items, std::uint32_t first, std::span<const Box> boxes,
                             std::uint32_t places) {
  if (items.size() <= 1) {
    if (items.empty()) return;
    place_of[items[0]] = first;
    position_of[first] = items[0];
    return;
  }
  const auto centre = [&](std::uint32_t item) { return boxes[item].lower * 0.5F + boxes[item].upper * 0.5F; };
  glm::vec3 lower = centre(items[0]);
  glm::vec3 upper = lower;
  for (const std::uint32_t item : items) {
    lower = glm::min(lower, centre(item));
    upper = glm::max(upper, centre(item));
  }
  const glm::vec3 extent = upper * 0.5F - lower * 0.5F;
  const glm::length_t axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
  const std::size_t half = (items.size() + 1) / 2;
  std::nth_element(items.begin(), items.begin() + static_cast<std::ptrdiff_t>(half), items.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return centre(a)[axis] < centre(b)[axis]; });
  sort_places(items.first(half), first, boxes, places / 2);
  sort_places(items.subspan(half), first + places / 2, boxes, places / 2);
}

std::uint32_t TreeSearch::best_match(std::uint32_t position) const {
  struct Open {
    std::size_t node;
    double bound;
  };
  std::array<Open, 64> stack;  // one more a level is left open, of at most 28
  std::size_t open = 0;
  const std::size_t own = first_place + place_of[position];
  const WideBox box = nodes[own];
  double smallest = kInfinity;
  std::uint32_t best = position;
  Open next{1, 0};
  while (true) {
    while (next.bound <= smallest && next.node < first_place) {
      const Open left{2 * next.node, distance(box, nodes[2 * next.node])};
      const Open right{left.node + 1, distance(box, nodes[left.node + 1])};
      const bool left_first = left.bound < right.bound;
      const Open& farther = left_first ? right : left;
      if (farther.bound <= smallest && farther.bound < kInfinity) stack[open++] = farther;
      next = left_first ? left : right;
    }
    if (next.bound <= smallest && next.bound < kInfinity && next.node != own) {  // its bound is its distance
      const std::uint32_t other = position_of[next.node - first_place];
      if (next.bound < smallest || other < best) best = other;
      smallest = next.bound;
    }
    if (open == 0) return best;
    next = stack[--open];
  }
}

void TreeSearch::merge(std::uint32_t a, std::uint32_t b) {
  const std::uint32_t place_a = place_of[a];
  const std::uint32_t place_b = place_of[b];
  nodes[first_place + place_a].enclose(nodes[first_place + place_b]);
  nodes[first_place + place_b] = nothing();
  update(place_a);
  update(place_b);
  place_of[b] = place_of.back();
  position_of[place_of[b]] = b;
  place_of.pop_back();
}

void TreeSearch::update(std::uint32_t place) {
  for (std::size_t node = (first_place + place) / 2; node > 0; node /= 2)
    nodes[node] = above(nodes[2 * node], nodes[2 * node + 1]);
}

}  // namespace cbvh::golden
