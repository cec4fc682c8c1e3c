// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "golden/scene/mesh.h"

namespace cbvh::golden {

/// The faces of a Wavefront OBJ in file order; polygon a b c d ... becomes the fan a b c, a c d, ...
Mesh read_obj(const std::string& path);

}  // namespace cbvh::golden
