// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/trace/surface.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "golden/build/float_tree.h"

namespace cbvh::golden {

SceneScale scene_scale(const Box& box) {
  const double diagonal = glm::length(glm::dvec3(box.upper) - glm::dvec3(box.lower));
  return {diagonal, static_cast<double>(largest_magnitude(box)) * 0x1p-22 + diagonal * 0x1p-17};
}

std::optional<Surface> surface_of(const std::array<glm::dvec3, 3>& corners, const Ray& ray, double t) {
  const glm::dvec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
  const double length = glm::length(normal);
  if (length == 0) return std::nullopt;
  const glm::dvec3 direction(ray.direction);
  const double side = glm::dot(normal, direction) > 0 ? -1 : 1;
  return Surface{glm::dvec3(ray.origin) + direction * t, normal * (side / length)};
}

double facing(const Surface& surface, const Ray& ray) {
  const glm::dvec3 direction(ray.direction);
  return std::clamp(-glm::dot(surface.normal, direction) / glm::length(direction), 0.0, 1.0);
}

Ray leaving(const Surface& surface, const glm::dvec3& direction, const SceneScale& scale) {
  return {glm::vec3(surface.point + surface.normal * scale.offset), glm::vec3(direction)};
}

bool can_leave(const Ray& ray) {
  return std::isfinite(ray.origin.x) && std::isfinite(ray.origin.y) && std::isfinite(ray.origin.z);
}

double sky(const glm::dvec3& direction) { return 0.5 + 0.5 * direction.y; }

}  // namespace cbvh::golden
