// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/tree/coverage.h"

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <cstddef>

namespace cbvh::golden {
namespace {

using Rational = boost::multiprecision::cpp_rational;
using Point = std::array<Rational, 3>;
/// Convex; of one or two corners a point or a segment.
using Polygon = std::vector<Point>;

Rational exactly(float x) { return Rational(static_cast<double>(x)); }

/// The closed part where sign * coordinate <= sign * plane.
Polygon clipped(const Polygon& polygon, std::size_t axis, const Rational& plane, int sign) {
  Polygon kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point& from = polygon[i];
    const Point& to = polygon[(i + 1) % polygon.size()];
    const Rational from_side = (from[axis] - plane) * sign;
    const Rational to_side = (to[axis] - plane) * sign;
    if (from_side <= 0) kept.push_back(from);
    if ((from_side < 0 && to_side > 0) || (from_side > 0 && to_side < 0)) {
      const Rational t = from_side / (from_side - to_side);
      Point point;
      for (std::size_t k = 0; k < 3; ++k) point[k] = from[k] + t * (to[k] - from[k]);
      kept.push_back(point);
    }
  }
  kept.erase(std::unique(kept.begin(), kept.end()), kept.end());
  if (kept.size() > 1 && kept.front() == kept.back()) kept.pop_back();
  return kept;
}

/// Appends the closures of what is left of a polygon outside of a closed box.
void subtract(Polygon polygon, const Box& box, std::vector<Polygon>& left) {
  struct Side {
    std::size_t axis;
    Rational plane;
    int outwards;
  };
  std::vector<Side> sides;
  for (int axis = 0; axis < 3; ++axis) {
    sides.push_back({static_cast<std::size_t>(axis), exactly(box.lower[axis]), -1});
    sides.push_back({static_cast<std::size_t>(axis), exactly(box.upper[axis]), 1});
  }
  const auto outside = [](const Side& side) {
    return [&side](const Point& point) { return (point[side.axis] - side.plane) * side.outwards > 0; };
  };
  for (const Side& side : sides) {
    if (std::all_of(polygon.begin(), polygon.end(), outside(side))) return left.push_back(std::move(polygon));
  }
  for (const Side& side : sides) {
    if (std::none_of(polygon.begin(), polygon.end(), outside(side))) continue;
    left.push_back(clipped(polygon, side.axis, side.plane, -side.outwards));
    polygon = clipped(polygon, side.axis, side.plane, side.outwards);
    if (polygon.empty()) return;
  }
}

/// The mean of the corners: in the polygon, and in none of the boxes that were subtracted.
std::array<double, 3> middle(const Polygon& polygon) {
  std::array<double, 3> result{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    Rational sum = 0;
    for (const Point& point : polygon) sum += point[axis];
    result[axis] = static_cast<double>(Rational(sum / polygon.size()));
  }
  return result;
}

}  // namespace

std::vector<CoverageGap> coverage_gaps(const FloatTree& tree, const Mesh& mesh, std::uint32_t stride,
                                       std::size_t most) {
  std::vector<std::vector<Box>> boxes(mesh.triangles.size());
  const auto hold = [&](std::size_t entry, const Box& box) {
    bool last = false;
    for (; !last; ++entry) {
      last = (tree.primitive_ids[entry] & kLastOfLeaf) != 0;
      boxes[tree.primitive_ids[entry] & ~kLastOfLeaf].push_back(box);
    }
  };
  if (tree.pairs.empty()) hold(0, tree.scene);
  for (const FloatPair& pair : tree.pairs) {
    for (int c = 0; c < 2; ++c) {
      if (pair.leaf[c]) hold(pair.pointer[c], pair.child[c]);
    }
  }
  std::vector<CoverageGap> gaps;
  for (std::size_t id = 0; id < boxes.size() && gaps.size() < most; id += stride) {
    Polygon triangle;
    for (int corner = 0; corner < 3; ++corner) {
      const glm::vec3& p = mesh.positions[mesh.triangles[id][corner]];
      triangle.push_back({exactly(p.x), exactly(p.y), exactly(p.z)});
    }
    std::vector<Polygon> uncovered{triangle};
    for (const Box& box : boxes[id]) {
      std::vector<Polygon> rest;
      for (Polygon& polygon : uncovered) subtract(std::move(polygon), box, rest);
      uncovered = std::move(rest);
    }
    if (!uncovered.empty()) gaps.push_back({static_cast<std::uint32_t>(id), middle(uncovered.front())});
  }
  return gaps;
}

}  // namespace cbvh::golden
