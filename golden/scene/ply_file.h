// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "golden/scene/mesh.h"

namespace cbvh::golden {

/// The faces of a PLY (ascii, or binary of either endianness) in file order; polygon a b c d ... becomes the fan a b c,
/// a c d, ... Ours rather than a library's: why, and what was measured, is in docs/scenes.md.
Mesh read_ply(const std::string& path);

}  // namespace cbvh::golden
