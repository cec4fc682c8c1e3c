// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/trace/compressed_view.h"

#include <fmt/format.h>

#include "golden/input_error.h"

namespace cbvh::golden {

CompressedTreeView::CompressedTreeView(const CompressedTree& tree)
    : tree_(&tree),
      code_mask_((Index{1} << static_cast<unsigned>(tree.rules.bits)) - 1),
      base_mask_(tree.code == Code::modulo ? -1 : 0),
      exclusive_(tree.rules.scale_rule == ScaleRule::equation2 ? 1 : 0) {
  if (fits_64_bits(tree.scene, tree.rules)) return;
  throw InputError("traversal", fmt::format("e_min: found {}, wanted the exactness limit {} or more",
                                            tree.rules.min_scale, exactness_limit(largest_magnitude(tree.scene))));
}

}  // namespace cbvh::golden
