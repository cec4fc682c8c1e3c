// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <glm/vec3.hpp>
#include <optional>

#include "golden/scene/mesh.h"
#include "golden/trace/ray.h"

namespace cbvh::golden {

/// A ray sheared so that it runs along its own z axis (Woop, Benthin, Wald: Watertight Ray/Triangle Intersection). The
/// test is in binary64: a vertex is sheared the same way for every triangle that has it, and an edge function of the
/// swapped vertices is the exact negative, so no ray passes between two triangles that share an edge.
class TriangleTest {
 public:
  explicit TriangleTest(const Ray& ray) : TriangleTest(widened(ray)) {}
  explicit TriangleTest(const WideRay& ray);

  /// t of the hit, unclamped; nothing if the ray's line misses the triangle or lies in its plane. Edges and vertices
  /// belong to the triangle.
  std::optional<double> operator()(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) const;

 private:
  struct Sheared {
    double x;
    double y;
    double z;  ///< t
  };
  Sheared shear(const glm::vec3& vertex) const;

  std::array<double, 3> origin_;
  std::array<int, 3> axes_;  ///< the last is the one in which the ray runs most
  double shear_x_;
  double shear_y_;
  double shear_z_;
};

}  // namespace cbvh::golden
