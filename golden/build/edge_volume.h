// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "golden/build/builder.h"

namespace cbvh::golden {

/// The edge volume heuristic (Dammertz, Keller 2008; EVH-BVH of the same): before the centroid sweep, triangles with an
/// edge around which the box has too much volume are divided at its middle.
BuilderKind edge_volume_builder();

}  // namespace cbvh::golden
