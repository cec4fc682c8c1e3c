// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/scene/rotate.h"

#include <cmath>

namespace cbvh::golden {
namespace {

/// Turns the axis `from` towards the axis `to`.
void turn(glm::dvec3& p, int from, int to) {
  const double half = std::sqrt(0.5);
  const double a = p[from];
  const double b = p[to];
  p[from] = (a - b) * half;
  p[to] = (a + b) * half;
}

}  // namespace

Mesh rotated(Mesh mesh) {
  for (glm::vec3& position : mesh.positions) {
    glm::dvec3 p(position);
    turn(p, 1, 2);
    turn(p, 2, 0);
    turn(p, 0, 1);
    position = glm::vec3(p);
  }
  return mesh;
}

}  // namespace cbvh::golden
