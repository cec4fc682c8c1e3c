// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/mat4x4.hpp>
#include <vector>

#include "golden/scene/gltf_accessor.h"

namespace cbvh::golden {

/// A mesh placed in the world.
struct MeshInstance {
  std::size_t mesh;
  glm::dmat4 to_world;
};

/// The meshes of the default scene (the first one if none is named) in depth-first order, children as listed. Without
/// any scene: the trees of all root nodes, then each mesh that no node refers to.
std::vector<MeshInstance> place_meshes(const GltfSource& source);

}  // namespace cbvh::golden
