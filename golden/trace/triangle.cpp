// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/trace/triangle.h"

#include <cmath>

namespace cbvh::golden {

TriangleTest::TriangleTest(const WideRay& ray) : origin_{ray.origin.x, ray.origin.y, ray.origin.z}, axes_{} {
  int most = 0;
  for (int axis = 1; axis < 3; ++axis) {
    if (std::abs(ray.direction[axis]) > std::abs(ray.direction[most])) most = axis;
  }
  axes_ = {(most + 1) % 3, (most + 2) % 3, most};
  const double along = ray.direction[most];
  shear_x_ = ray.direction[axes_[0]] / along;
  shear_y_ = ray.direction[axes_[1]] / along;
  shear_z_ = 1 / along;
}

TriangleTest::Sheared TriangleTest::shear(const glm::vec3& vertex) const {
  const auto from_origin = [&](int axis) {
    return static_cast<double>(vertex[axis]) - origin_[static_cast<std::size_t>(axis)];
  };
  const double z = from_origin(axes_[2]);
  return {from_origin(axes_[0]) - shear_x_ * z, from_origin(axes_[1]) - shear_y_ * z, shear_z_ * z};
}

std::optional<double> TriangleTest::operator()(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) const {
  const Sheared p = shear(a);
  const Sheared q = shear(b);
  const Sheared r = shear(c);
  const double u = r.x * q.y - r.y * q.x;
  const double v = p.x * r.y - p.y * r.x;
  const double w = q.x * p.y - q.y * p.x;
  if ((u < 0 || v < 0 || w < 0) && (u > 0 || v > 0 || w > 0)) return std::nullopt;
  const double determinant = u + v + w;
  if (determinant == 0) return std::nullopt;
  return (u * p.z + v * q.z + w * r.z) / determinant;
}

}  // namespace cbvh::golden
