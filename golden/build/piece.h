// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include "golden/build/clip.h"
#include "golden/build/float_tree.h"

namespace cbvh::golden {

/// A triangle, or the part of it in a node: its ID and the box of that part.
struct Piece {
  Box box;
  std::uint32_t id;
};

/// At least one piece.
inline Box box_of(std::span<const Piece> pieces) {
  Box box = pieces.front().box;
  for (const Piece& piece : pieces) box = unite(box, piece.box);
  return box;
}

inline Corners corners_of(const Mesh& mesh, std::uint32_t id) {
  const glm::uvec3& t = mesh.triangles[id];
  return {mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z]};
}

}  // namespace cbvh::golden
