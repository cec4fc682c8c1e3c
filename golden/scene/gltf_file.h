// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "golden/scene/mesh.h"

namespace cbvh::golden {

/// The triangles of a glTF 2.0 scene, node transforms applied; points and lines are skipped. See docs/scenes.md.
Mesh read_glb(const std::string& path);
Mesh read_gltf(const std::string& path);

}  // namespace cbvh::golden
