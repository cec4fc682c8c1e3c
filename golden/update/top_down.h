// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "golden/build/float_tree.h"
#include "golden/tree/compressed_tree.h"

namespace cbvh::golden {

/// The reference compressor: from the root's own grid downwards, every node on its parent's own grid (DESIGN section 3,
/// rules 2, 4 and 5; the paper's equations 1 and 2). Any e_min; throws InputError when the rules are out of their
/// domain.
CompressedTree compress_top_down(const FloatTree& tree, const GridRules& rules, Code code);

}  // namespace cbvh::golden
