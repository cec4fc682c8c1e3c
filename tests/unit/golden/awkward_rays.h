// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>
#include <random>

#include "golden/input_error.h"
#include "golden/scene/mesh.h"
#include "golden/trace/ray.h"

namespace cbvh::golden {

/// Rays from around the scene to points in it: anywhere, along axes, at midpoints of edges, at vertices, and so close
/// to a triangle's plane that t is hardly determined.
class AwkwardRays {
 public:
  AwkwardRays(const Mesh& mesh, std::uint64_t seed) : mesh_(mesh), random_(seed) {}

  Ray next(int kind) {
    if (kind == 4) return grazing();
    const glm::vec3 to = kind == 3 ? corner() : kind == 2 ? (corner() + corner()) * 0.5F : anywhere();
    Ray ray{anywhere(), {}};
    if (kind == 1) {
      ray.direction[static_cast<int>(random_() % 3)] = random_() % 2 == 0 ? 1.0F : -2.0F;
      for (int axis = 0; axis < 3; ++axis) {
        if (ray.direction[axis] == 0 && random_() % 2 == 0) ray.direction[axis] = -0.0F;
        if (ray.direction[axis] == 0) ray.origin[axis] = corner()[axis];
      }
    } else {
      ray.direction = to - ray.origin;
    }
    return ray;
  }

 private:
  Ray grazing() {
    const glm::uvec3& triangle = mesh_.triangles[random_() % mesh_.triangles.size()];
    const glm::vec3 a = mesh_.positions[triangle.x];
    const glm::vec3 to = mesh_.positions[triangle.y];
    glm::vec3 from = a + (a - to) * 3.0F;
    float& moved = from[static_cast<int>(random_() % 3)];
    moved = std::nextafter(moved, random_() % 2 == 0 ? INFINITY : -INFINITY);
    return {from, to - from};
  }
  glm::vec3 corner() {
    const glm::uvec3& triangle = mesh_.triangles[random_() % mesh_.triangles.size()];
    return mesh_.positions[triangle[static_cast<int>(random_() % 3)]];
  }
  glm::vec3 anywhere() {
    const auto part = [&] { return static_cast<float>(random_() % 1024) / 512.0F - 0.5F; };
    const glm::vec3 a = corner();
    const glm::vec3 b = corner();
    return a + glm::vec3(part(), part(), part()) * (b - a);
  }

  const Mesh& mesh_;
  std::mt19937_64 random_;
};

inline bool can_be_traced(const Ray& ray) {
  try {
    check_ray(ray, "ray");
  } catch (const InputError&) {
    return false;
  }
  return true;
}

}  // namespace cbvh::golden
