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

  /// Where the ray is inside the closed box; of a box that is wider by `slack`, at least 0, on every side.
  Interval inside(const Box& box, double slack = 0) const { return inside(box, slack, ends_); }

  /// Where its line is, whatever t_min and t_max.
  Interval line_inside(const Box& box) const {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    return inside(box, 0, {-kInfinity, kInfinity});
  }

 private:
  /// 1 / direction, the difference and the product round by 2^-53 each; so does the widening itself.
  static constexpr double kWiden = 0x1p-50;

  /// Widening is monotone, so the widened entry is the latest of the planes' widened ones, and likewise the exit.
  Interval inside(const Box& box, double slack, const Interval& ends) const {
    double near = -std::numeric_limits<double>::infinity();
    double far = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
      const auto a = static_cast<std::size_t>(axis);
      const double lower = static_cast<double>(box.lower[axis]) - origin_[a] - slack;
      const double upper = static_cast<double>(box.upper[axis]) - origin_[a] + slack;
      if (parallel_[a]) {
        if (lower > 0 || upper < 0) return {1, 0};
        continue;
      }
      const double to_lower = lower * inverse_[a];
      const double to_upper = upper * inverse_[a];
      near = std::max(near, std::min(to_lower, to_upper));
      far = std::min(far, std::max(to_lower, to_upper));
    }
    return {std::max(ends.entry, near - std::abs(near) * kWiden), std::min(ends.exit, far + std::abs(far) * kWiden)};
  }

  Interval ends_;  ///< t_min and t_max
  std::array<double, 3> origin_;
  std::array<double, 3> inverse_;
  std::array<bool, 3> parallel_;
};

}  // namespace cbvh::golden
