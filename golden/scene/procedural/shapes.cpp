// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/scene/procedural/shapes.h"

#include <cmath>

#include "golden/scene/procedural/random.h"

namespace cbvh::golden {

float dot(const glm::vec3& a, const glm::vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

glm::vec3 cross(const glm::vec3& a, const glm::vec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

glm::vec3 normalized(const glm::vec3& v) { return v / std::sqrt(dot(v, v)); }

glm::vec3 Random::direction() {
  while (true) {
    const glm::vec3 v = in_cube(1.0f);
    const float square = dot(v, v);
    if (square <= 1.0f && square > 0x1p-20f) return v / std::sqrt(square);
  }
}

void append_quad(Mesh& mesh, std::uint64_t a, std::uint64_t b, std::uint64_t c, std::uint64_t d) {
  mesh.triangles.emplace_back(a, b, c);
  mesh.triangles.emplace_back(a, c, d);
}

std::uint64_t sphere_subdivision(std::uint64_t triangles, std::uint64_t count) {
  std::uint64_t k = 1;
  while (count * 8 * (k + 1) * (k + 1) <= triangles) ++k;
  return k;
}

void append_sphere(Mesh& mesh, const glm::vec3& centre, float radius, std::uint64_t k) {
  for (int octant = 0; octant < 8; ++octant) {
    const glm::vec3 sign((octant & 1) != 0 ? -1.0f : 1.0f, (octant & 2) != 0 ? -1.0f : 1.0f,
                         (octant & 4) != 0 ? -1.0f : 1.0f);
    const std::uint64_t base = mesh.positions.size();
    // Row i holds the i + 1 points with z = k - i.
    for (std::uint64_t i = 0; i <= k; ++i) {
      for (std::uint64_t j = 0; j <= i; ++j) {
        const glm::vec3 on_face(static_cast<float>(i - j), static_cast<float>(j), static_cast<float>(k - i));
        mesh.positions.push_back(centre + normalized(on_face) * sign * radius);
      }
    }
    const auto vertex = [&](std::uint64_t i, std::uint64_t j) { return base + i * (i + 1) / 2 + j; };
    for (std::uint64_t i = 0; i < k; ++i) {
      for (std::uint64_t j = 0; j <= i; ++j) {
        mesh.triangles.emplace_back(vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1));
        if (j < i) mesh.triangles.emplace_back(vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1));
      }
    }
  }
}

}  // namespace cbvh::golden
