// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "golden/build/builder.h"

namespace cbvh::golden {

/// KD-BVH (paper 001, section 4.5): a SAH k-d tree, whose nodes are the cells that planes cut out, made into a BVH:
/// empty leaves are left out, boxes refitted to the triangles' parts in the leaves. A node of more than `leaf`
/// triangles that no plane makes cheaper is split by objects.
BuilderKind kdtree_builder();

}  // namespace cbvh::golden
