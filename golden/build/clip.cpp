// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/build/clip.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/common.hpp>
#include <limits>

#include "golden/build/triangle_box.h"

namespace cbvh::golden {
namespace {

using Point = std::array<double, 3>;

/// A polygon, convex but for rounding. A plane replaces each run of corners by two: from three, six planes make at most
/// 28.
struct Polygon {
  std::array<Point, 28> corners;
  std::size_t size = 0;
  void add(const Point& point) { corners[size++] = point; }
};

/// Where the edge meets the plane. Each coordinate is within 2^-49 of the axis's largest magnitude of the exact one.
Point crossing(const Point& from, const Point& to, std::size_t axis, double plane) {
  const double t = (plane - from[axis]) / (to[axis] - from[axis]);
  Point point;
  for (std::size_t i = 0; i < 3; ++i) point[i] = from[i] + t * (to[i] - from[i]);
  point[axis] = plane;
  return point;
}

/// The part where sign * coordinate <= sign * plane.
Polygon clipped(const Polygon& polygon, std::size_t axis, double plane, double sign) {
  Polygon kept;
  for (std::size_t i = 0; i < polygon.size; ++i) {
    const Point& from = polygon.corners[i];
    const Point& to = polygon.corners[i + 1 == polygon.size ? 0 : i + 1];
    const bool from_in = sign * from[axis] <= sign * plane;
    const bool to_in = sign * to[axis] <= sign * plane;
    if (from_in) kept.add(from);
    if (from_in != to_in) kept.add(crossing(from, to, axis, plane));
  }
  return kept;
}

}  // namespace

float rounded_down(double x) {
  const auto near = static_cast<float>(x);
  return static_cast<double>(near) > x ? std::nextafter(near, -std::numeric_limits<float>::infinity()) : near;
}

float rounded_up(double x) { return -rounded_down(-x); }

std::optional<Box> clipped_box(const Corners& triangle, const Box& within) {
  const Box whole = triangle_box(triangle[0], triangle[1], triangle[2]);
  const Box limit{glm::max(whole.lower, within.lower), glm::min(whole.upper, within.upper)};
  Polygon polygon;
  for (const glm::vec3& corner : triangle) polygon.add({corner.x, corner.y, corner.z});
  // Six roundings of 2^-49 each stay below the margin, so that a polygon clipped a margin further out, and its box
  // made larger by a margin, contain the exact ones.
  Point margin{};
  for (int i = 0; i < 3; ++i) {
    if (limit.lower[i] > limit.upper[i]) return std::nullopt;
    const auto axis = static_cast<std::size_t>(i);
    margin[axis] = 0x1p-46 * static_cast<double>(std::max(std::abs(whole.lower[i]), std::abs(whole.upper[i])));
    if (limit.lower[i] > whole.lower[i])
      polygon = clipped(polygon, axis, static_cast<double>(limit.lower[i]) - margin[axis], -1);
    if (limit.upper[i] < whole.upper[i])
      polygon = clipped(polygon, axis, static_cast<double>(limit.upper[i]) + margin[axis], 1);
  }
  if (polygon.size == 0) return std::nullopt;
  Box box{};
  for (int i = 0; i < 3; ++i) {
    const auto axis = static_cast<std::size_t>(i);
    double lower = polygon.corners[0][axis];
    double upper = lower;
    for (std::size_t k = 1; k < polygon.size; ++k) {
      lower = std::min(lower, polygon.corners[k][axis]);
      upper = std::max(upper, polygon.corners[k][axis]);
    }
    box.lower[i] = std::max(limit.lower[i], rounded_down(std::max(lower - margin[axis], -0x1.fffffep127)) + 0.0F);
    box.upper[i] = std::min(limit.upper[i], rounded_up(std::min(upper + margin[axis], 0x1.fffffep127)) + 0.0F);
    if (box.lower[i] > box.upper[i]) return std::nullopt;
  }
  return box;
}

}  // namespace cbvh::golden
