// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "golden/scene/mesh.h"

namespace cbvh::golden {

/// The mesh turned by 45 degrees around x, then y, then z: what lay along the axes no longer does (paper 001, table 2).
/// In binary64 with the square root of 1/2, rounded once; the same bits with every compiler. Coordinates at the edge of
/// binary32 may become infinite, which check_mesh refuses.
Mesh rotated(Mesh mesh);

}  // namespace cbvh::golden
