// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "golden/build/float_tree.h"

namespace cbvh::golden {

/// The linear BVH of DESIGN 3.2: triangles in order of the Morton codes of their boxes' centres (equal codes keep their
/// input order and share a leaf), split at the highest differing bit, emitted depth first and bottom up. Throws
/// InputError as triangle_boxes does.
FloatTree build_lbvh(const Mesh& mesh);

}  // namespace cbvh::golden
