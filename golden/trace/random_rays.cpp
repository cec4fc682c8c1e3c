// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/trace/random_rays.h"

#include <glm/geometric.hpp>

#include "golden/trace/random.h"

namespace cbvh::golden {

Ray ray_from_within(const Box& box, std::uint64_t index) {
  CounterRandom random(index, 0, 0);
  Ray ray;
  for (int axis = 0; axis < 3; ++axis) {
    const auto lower = static_cast<double>(box.lower[axis]);
    const double at = lower + (static_cast<double>(box.upper[axis]) - lower) * random.next();
    ray.origin[axis] = static_cast<float>(at);
  }
  ray.direction = glm::vec3(any_direction(random));
  return ray;
}

Ray ray_across(const Box& box, std::uint64_t index) {
  const glm::dvec3 lower(box.lower);
  const glm::dvec3 upper(box.upper);
  const glm::dvec3 middle = lower * 0.5 + upper * 0.5;
  const double radius = glm::length(upper - lower) * 0.5;
  for (std::uint64_t tried = 0;; ++tried) {  // lines through the sphere around the box, until one meets the box
    CounterRandom random(index, 1, tried);
    const glm::dvec3 inwards = any_direction(random);
    Ray ray;
    ray.origin = glm::vec3(middle - inwards * radius);
    ray.direction = glm::vec3(diffuse_direction(inwards, random));
    if (!PreparedRay(ray).inside(box).empty()) return ray;
  }
}

}  // namespace cbvh::golden
