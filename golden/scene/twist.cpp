// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/scene/twist.h"

#include <cmath>
#include <glm/common.hpp>
#include <numbers>

namespace cbvh::golden {

Mesh twisted(Mesh mesh, float turns) {
  if (mesh.positions.empty()) return mesh;
  glm::dvec3 lower(mesh.positions.front());
  glm::dvec3 upper = lower;
  for (const glm::vec3& position : mesh.positions) {
    lower = glm::min(lower, glm::dvec3(position));
    upper = glm::max(upper, glm::dvec3(position));
  }
  const glm::dvec3 middle = (lower + upper) * 0.5;
  const double height = upper.y - lower.y;
  if (!(height > 0)) return mesh;
  for (glm::vec3& position : mesh.positions) {
    const glm::dvec3 p(position);
    const double angle = 2 * std::numbers::pi * static_cast<double>(turns) * ((p.y - lower.y) / height);
    const glm::dvec3 arm = p - middle;
    const glm::vec3 turned(middle.x + arm.x * std::cos(angle) + arm.z * std::sin(angle), p.y,
                           middle.z - arm.x * std::sin(angle) + arm.z * std::cos(angle));
    if (std::isfinite(turned.x) && std::isfinite(turned.z)) position = turned;
  }
  return mesh;
}

}  // namespace cbvh::golden
