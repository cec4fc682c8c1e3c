// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/trace/random.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <optional>

namespace cbvh::golden {

namespace {

/// A try at a point on the sphere of radius 1; half of all tries succeed.
std::optional<glm::dvec3> on_sphere(CounterRandom& random) {
  const auto coordinate = [&random] { return 2 * random.next() - 1; };
  const double x = coordinate();
  const double y = coordinate();
  const glm::dvec3 in_cube(x, y, coordinate());
  const double square = glm::dot(in_cube, in_cube);
  if (square > 1 || square < 1e-6) return std::nullopt;
  return in_cube / std::sqrt(square);
}

}  // namespace

glm::dvec3 any_direction(CounterRandom& random) {
  while (true) {
    if (const auto direction = on_sphere(random)) return *direction;
  }
}

glm::dvec3 diffuse_direction(const glm::dvec3& normal, CounterRandom& random) {
  while (true) {
    const auto direction = on_sphere(random);
    if (!direction) continue;
    const glm::dvec3 sum = normal + *direction;  // on the sphere that touches the surface from above
    const double length = glm::length(sum);
    if (length > 1e-3) return sum / length;
  }
}

}  // namespace cbvh::golden
