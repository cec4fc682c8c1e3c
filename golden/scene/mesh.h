// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

namespace cbvh::golden {

/// Indexed triangles in world space. Every index is below positions.size(); every position is finite.
struct Mesh {
  std::string name;  ///< as reports print it: the file's stem, or the whole `proc:` text
  std::vector<glm::vec3> positions;
  std::vector<glm::uvec3> triangles;  ///< at most 2^27
};

}  // namespace cbvh::golden
