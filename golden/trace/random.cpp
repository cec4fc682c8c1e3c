// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/trace/random.h"

#include <cmath>
#include <glm/geometric.hpp>

namespace cbvh::golden {

glm::dvec3 diffuse_direction(const glm::dvec3& normal, CounterRandom& random) {
  const auto coordinate = [&random] { return 2 * random.next() - 1; };
  while (true) {  // half of all points of the cube will do
    const double x = coordinate();
    const double y = coordinate();
    const glm::dvec3 in_cube(x, y, coordinate());
    const double square = glm::dot(in_cube, in_cube);
    if (square > 1 || square < 1e-6) continue;
    const glm::dvec3 sum = normal + in_cube / std::sqrt(square);  // on the sphere that touches the surface from above
    const double length = glm::length(sum);
    if (length > 1e-3) return sum / length;
  }
}

}  // namespace cbvh::golden
