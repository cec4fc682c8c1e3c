// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/trace/triangle.h"

#include "golden/trace/exact_triangle.h"

namespace cbvh::golden {

TriangleTest::TriangleTest(const WideRay& ray) : ray_(ray), origin_{}, axes_{} {
  int most = 0;
  for (int axis = 1; axis < 3; ++axis) {
    if (std::abs(ray.direction[axis]) > std::abs(ray.direction[most])) most = axis;
  }
  axes_ = {(most + 1) % 3, (most + 2) % 3, most};
  for (std::size_t i = 0; i < 3; ++i) origin_[i] = ray.origin[axes_[i]];
  const double along = ray.direction[most];
  shear_x_ = ray.direction[axes_[0]] / along;
  shear_y_ = ray.direction[axes_[1]] / along;
  shear_z_ = 1 / along;
}

std::optional<double> TriangleTest::exactly(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) const {
  const std::optional<ExactDistance> t = exact_line_hit(ray_, a, b, c);
  return t ? std::optional(rounded(*t)) : std::nullopt;
}

}  // namespace cbvh::golden
