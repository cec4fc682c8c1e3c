// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "golden/quantize/cells.h"
#include "golden/quantize/grid.h"

namespace cbvh::golden {

/// The finest grid on which every decoded edge of a scene is a float: max(-149, ilogb(largest_magnitude) - 23), and
/// -149 for 0. This is `auto`, the default e_min (DESIGN section 3, rule 3). `largest_magnitude` is the largest
/// |coordinate| of the scene's boxes.
int exactness_limit(float largest_magnitude);

/// Throws InputError naming the field when bits are not 2..8 or min_scale is not -149..127.
void check_rules(const GridRules& rules);

/// The exponent of a node's own grid, from the cells it spans on its parent's grid of 2^scale: the finest on which it
/// spans at most rules.max_cells(), and not finer than e_min (rule 4; the paper's equation 2). 1 <= cells <=
/// rules.max_cells().
template <class Index>
int own_scale(const Index& cells, int scale, const GridRules& rules) {
  std::int64_t spanned = static_cast<std::int64_t>(cells) * 2;
  while (spanned <= rules.max_cells() && scale > rules.min_scale) {
    spanned *= 2;
    --scale;
  }
  return scale;
}

/// The smallest e >= e_min for which [lower, upper] touches at most rules.max_cells() cells of 2^e: the root's own grid
/// (rule 4) and, on the node's float box, the estimate of a node's own grid before its parent exists (rule 6).
int enclosing_scale(float lower, float upper, const GridRules& rules);

/// A node's own grid and lower index, from its cells on its parent's grid of 2^scale (rule 4).
template <class Index>
AxisContext<Index> own_context(const Cells<Index>& cells, int scale, const GridRules& rules) {
  const int own = own_scale(Index(cells.upper - cells.lower), scale, rules);
  return {own, times_power_of_two(cells.lower, scale - own)};
}

/// The root's own grid and lower index, from its float interval; also the estimated context of a subtree (rules 4 and
/// 6).
template <class Index>
AxisContext<Index> root_context(float lower, float upper, const GridRules& rules) {
  const int scale = enclosing_scale(lower, upper, rules);
  return {scale, floor_on_grid<Index>(lower, scale)};
}

/// All three axes of `root_context`.
template <class Index>
Context<Index> root_context(const Box& box, const GridRules& rules) {
  return {root_context<Index>(box.lower.x, box.upper.x, rules), root_context<Index>(box.lower.y, box.upper.y, rules),
          root_context<Index>(box.lower.z, box.upper.z, rules)};
}

}  // namespace cbvh::golden
