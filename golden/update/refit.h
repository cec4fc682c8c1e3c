// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "golden/build/float_tree.h"

namespace cbvh::golden {

/// The same topology around moved triangles: every box anew, bottom up (Wald's refit; the paper's section 5.2). `mesh`
/// has as many triangles as the tree has primitives; throws InputError otherwise, and as triangle_boxes does.
FloatTree refit(FloatTree tree, const Mesh& mesh);

/// The same in place on several threads (Wald, Ize, Parker, section 6): one finds the subtrees below the top of the
/// tree, each thread takes subtree after subtree, and at the end one joins them. Bit for bit what one thread makes.
void refit_in_place(FloatTree& tree, const Mesh& mesh, unsigned threads);

}  // namespace cbvh::golden
