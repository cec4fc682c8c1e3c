// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "golden/build/builder.h"

namespace cbvh::golden {

/// SS-BVH (paper 001, section 5): a plane at a boundary of the parts' boxes splits a node and the triangles across it.
/// Size against quality: `gain` and `references`; when the references are used up, nodes are split by objects. With
/// `objects=1` (end of section 5.1) the cheaper of plane and centroid sweep; with `tight=1` planes are weighed by the
/// tight boxes of their sides (section 5.2).
BuilderKind spatial_builder();

}  // namespace cbvh::golden
