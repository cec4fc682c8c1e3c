// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

#include "golden/scene/mesh.h"

namespace cbvh::golden {

/// glm's versions may use instructions that round differently; these do not.
float dot(const glm::vec3& a, const glm::vec3& b);
glm::vec3 cross(const glm::vec3& a, const glm::vec3& b);
glm::vec3 normalized(const glm::vec3& v);

/// Appends a sphere of 8 k^2 triangles: an octahedron, each face cut into k^2, pushed out to the radius.
void append_sphere(Mesh& mesh, const glm::vec3& centre, float radius, std::uint64_t k);

/// Greatest k >= 1 for which `count` spheres have at most `triangles` triangles, or 1.
std::uint64_t sphere_subdivision(std::uint64_t triangles, std::uint64_t count);

/// Appends a quad a b c d as the triangles a b c and a c d.
void append_quad(Mesh& mesh, std::uint64_t a, std::uint64_t b, std::uint64_t c, std::uint64_t d);

}  // namespace cbvh::golden
