// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "golden/build/float_tree.h"

namespace cbvh::golden {

/// The same topology around moved triangles: every box anew, bottom up (Wald's refit; the paper's section 5.2). `mesh`
/// has as many triangles as the tree has primitives; throws InputError otherwise, and as triangle_boxes does.
FloatTree refit(FloatTree tree, const Mesh& mesh);

}  // namespace cbvh::golden
