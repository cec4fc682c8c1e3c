// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "golden/scene/mesh.h"

namespace cbvh::golden {

/// The scene that `spec` names: a file "x.glb", "x.gltf", "x.obj" or "x.ply", or "proc:NAME[,key=value...]"; with
/// "rotated:" before any of these, that scene turned by 45 degrees around all axes (rotate.h). Triangles keep the
/// file's order, degenerate ones included. Throws InputError, and nothing else, when there is no valid scene.
Mesh load_scene(const std::string& spec);

/// The NAMEs that "proc:NAME" takes.
std::vector<std::string> procedural_scene_names();

/// Each procedural scene and its options with default and range, as --help prints them.
std::string procedural_scene_help();

}  // namespace cbvh::golden
