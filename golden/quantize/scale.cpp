// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/quantize/scale.h"

#include <algorithm>
#include <cmath>

#include "golden/input_error.h"

namespace cbvh::golden {

int exactness_limit(float largest_magnitude) {
  if (largest_magnitude == 0.0F) return -149;
  return std::max(-149, floor_log2(std::abs(static_cast<double>(largest_magnitude))) - 23);
}

void check_rules(const GridRules& rules) {
  if (rules.bits < 2 || rules.bits > 8) throw InputError("bits", fmt::format("found {}, want 2..8", rules.bits));
  if (rules.min_scale < -149 || rules.min_scale > 127) {
    throw InputError("min-scale", fmt::format("found {}, want -149..127", rules.min_scale));
  }
}

int enclosing_scale(float lower, float upper, const GridRules& rules) {
  const double p = static_cast<double>(lower);
  const double q = static_cast<double>(upper);
  // On a grid of 2^e the interval touches more than (q - p) / 2^e cells: no e below floor(log2(q - p)) - N can fit. The
  // extra one is for a difference that rounded up to a power of two.
  int scale = rules.min_scale;
  if (q > p) scale = std::max(scale, floor_log2(q - p) - rules.bits - 1);
  const double most_cells = static_cast<double>(rules.max_cells());
  for (;; ++scale) {
    const double unit = power_of_two(-scale);
    // The difference may be rounded, but rounding is monotonic and most_cells is a double: the comparison is exact.
    if (exact_floor(q * unit) - exact_floor(p * unit) <= most_cells - 1.0) return scale;
  }
}

}  // namespace cbvh::golden
