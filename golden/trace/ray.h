// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/vec3.hpp>
#include <limits>
#include <string>

#include "golden/quantize/grid.h"

namespace cbvh::golden {

/// A ray: points origin + t * direction for t in [t_min, t_max]. The direction need not have length 1; components may
/// be zero of either sign, not all of them. t_max may be infinite.
struct Ray {
  glm::vec3 origin;
  glm::vec3 direction;
  float t_min = 0;
  float t_max = std::numeric_limits<float>::infinity();
};

/// A ray in binary64, as the space of an instance sees one. Finite; not all components of the direction are zero.
struct WideRay {
  glm::dvec3 origin;
  glm::dvec3 direction;
  double t_min;
  double t_max;
};

inline WideRay widened(const Ray& ray) {
  return {glm::dvec3(ray.origin), glm::dvec3(ray.direction), static_cast<double>(ray.t_min),
          static_cast<double>(ray.t_max)};
}

/// Throws InputError at `place` for a direction of zeros, a NaN, an infinite origin or direction, or t_min > t_max.
void check_ray(const Ray& ray, const std::string& place);

/// Where a ray is inside of something: t from entry to exit; nowhere if entry > exit.
struct Interval {
  double entry;
  double exit;
  bool empty() const { return !(entry <= exit); }
};

/// A ray with what every box test needs of it. Box tests are in binary64 and widen: the interval encloses the exact one
/// (docs/arithmetic.md). They are monotone: the interval of a box that encloses another encloses the other's interval,
/// bit for bit, because every operation that rounds is monotone. So a hit whose t is clamped to its triangle's box
/// is found through every tree whose boxes enclose the triangle, and the nearest hit does not depend on the tree.
class PreparedRay {
 public:
  explicit PreparedRay(const Ray& ray) : PreparedRay(widened(ray)) {}
  explicit PreparedRay(const WideRay& ray);

  /// Whether t is between t_min and t_max.
  bool reaches(double t) const { return ends_.entry <= t && t <= ends_.exit; }

  /// Where the ray is inside the closed box.
  Interval inside(const Box& box) const { return clipped(line_inside(box)); }

  /// The same of a box that is wider by `slack`, at least 0, on every side.
  Interval inside(const Box& box, double slack) const {
    return clipped(line_inside(glm::dvec3(box.lower) - slack, glm::dvec3(box.upper) + slack));
  }

  /// Where its line is, whatever t_min and t_max.
  Interval line_inside(const Box& box) const { return line_inside(glm::dvec3(box.lower), glm::dvec3(box.upper)); }

 private:
  /// 1 / direction, the difference and the product round by 2^-53 each; so does the widening itself.
  static constexpr double kWiden = 0x1p-50;

  Interval clipped(const Interval& line) const {
    return {std::max(ends_.entry, line.entry), std::min(ends_.exit, line.exit)};
  }

  /// Widening is monotone, so the widened entry is the latest of the planes' widened ones, and likewise the exit.
  Interval line_inside(const glm::dvec3& lower, const glm::dvec3& upper) const {
    Interval line{-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    if (!clip(0, lower.x, upper.x, line) || !clip(1, lower.y, upper.y, line) || !clip(2, lower.z, upper.z, line))
      return {std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    return {line.entry - std::abs(line.entry) * kWiden, line.exit + std::abs(line.exit) * kWiden};
  }

  /// False if the ray is parallel to the axis's planes and not between them.
  bool clip(std::size_t axis, double lower, double upper, Interval& line) const {
    const double to_lower = lower - origin_[axis];
    const double to_upper = upper - origin_[axis];
    if (parallel_[axis]) return to_lower <= 0 && to_upper >= 0;
    const double one = to_lower * inverse_[axis];
    const double other = to_upper * inverse_[axis];
    line.entry = std::max(line.entry, std::min(one, other));
    line.exit = std::min(line.exit, std::max(one, other));
    return true;
  }

  Interval ends_;  ///< t_min and t_max
  std::array<double, 3> origin_;
  std::array<double, 3> inverse_;
  std::array<bool, 3> parallel_;
};

}  // namespace cbvh::golden
