// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/gtc/type_ptr.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "golden/scene/mesh.h"
#include "golden/trace/ray.h"

namespace cbvh::golden {

/// A ray sheared so that it runs along its own z axis (Woop, Benthin, Wald: Watertight Ray/Triangle Intersection).
/// Whether it hits is exact: where binary64 cannot be sure of an edge function's sign (docs/arithmetic.md), integers
/// decide. So no ray passes between two triangles that share an edge, nor is one hit beside its edges.
class TriangleTest {
 public:
  explicit TriangleTest(const Ray& ray) : TriangleTest(widened(ray)) {}
  explicit TriangleTest(const WideRay& ray);

  /// t of the hit, rounded and unclamped; nothing if the ray's line misses the triangle or lies in its plane. Edges and
  /// vertices belong to the triangle.
  std::optional<double> operator()(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) const {
    double reach = 0;
    const Sheared p = shear(a, reach);
    const Sheared q = shear(b, reach);
    const Sheared r = shear(c, reach);
    const double u = r.x * q.y - r.y * q.x;
    const double v = p.x * r.y - p.y * r.x;
    const double w = q.x * p.y - q.y * p.x;
    const double least = std::min(std::min(u, v), w);
    const double most = std::max(std::max(u, v), w);
    const double unsure = reach * reach * kUnsure;
    if (least < -unsure && most > unsure) return std::nullopt;
    if (least > unsure || most < -unsure) return (u * p.z + v * q.z + w * r.z) / (u + v + w);
    return exactly(a, b, c);
  }

 private:
  /// Of the edge functions' error, over the square of the largest coordinate of a vertex seen from the origin.
  static constexpr double kUnsure = 0x1p-46;

  struct Sheared {
    double x;
    double y;
    double z;  ///< t
  };
  /// `reach` becomes the largest coordinate seen from the origin.
  Sheared shear(const glm::vec3& vertex, double& reach) const {
    const auto from_origin = [&](std::size_t i) {
      const double offset = static_cast<double>(glm::value_ptr(vertex)[axes_[i]]) - origin_[i];
      reach = std::max(reach, std::abs(offset));
      return offset;
    };
    const double z = from_origin(2);
    return {from_origin(0) - shear_x_ * z, from_origin(1) - shear_y_ * z, shear_z_ * z};
  }
  std::optional<double> exactly(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) const;

  WideRay ray_;
  std::array<double, 3> origin_;  ///< in the order of axes_
  std::array<int, 3> axes_;       ///< the last is the one in which the ray runs most
  double shear_x_;
  double shear_y_;
  double shear_z_;
};

}  // namespace cbvh::golden
