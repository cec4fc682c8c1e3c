// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "golden/input_error.h"
#include "golden/scene/mesh.h"

namespace cbvh::golden {

/// Leaf pointers have 27 bits (DESIGN section 4).
inline constexpr std::uint64_t kMaxTriangles = std::uint64_t{1} << 27;
/// What kMaxTriangles can use when no vertex is shared.
inline constexpr std::uint64_t kMaxVertices = 3 * kMaxTriangles;

/// Throws InputError when a scene of this size is refused. Called before memory is taken for it.
void check_size(std::uint64_t triangles, std::uint64_t vertices, const std::string& place);

/// Throws InputError, naming the triangle or vertex, unless the mesh keeps what mesh.h promises and has a triangle.
void check_mesh(const Mesh& mesh, const std::string& place);

/// 'vertex 7: y is nan, wanted a finite number', or empty when all three coordinates are finite.
std::string non_finite(const glm::vec3& position, std::uint64_t vertex);

}  // namespace cbvh::golden
