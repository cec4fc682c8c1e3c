// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "golden/quantize/exact.h"
#include "golden/quantize/grid.h"

namespace cbvh::golden {

/// floor(x / 2^scale), exactly: a float has 24 significant bits and |scale| <= 149, so the quotient is a double.
/// With 64-bit indices `scale` must keep |x / 2^scale| below 2^62 (anything at or above the exactness limit does).
template <class Index>
Index floor_on_grid(float x, int scale) {
  return Index(exact_floor(static_cast<double>(x) * power_of_two(-scale)));
}
template <>
inline std::int64_t floor_on_grid<std::int64_t>(float x, int scale) {
  return static_cast<std::int64_t>(exact_floor(static_cast<double>(x) * power_of_two(-scale)));
}

/// ceil(x / 2^scale), exactly.
template <class Index>
Index ceil_on_grid(float x, int scale) {
  return -floor_on_grid<Index>(-x, scale);
}

/// The cells of a grid of 2^scale that a float interval touches: floor(lower / 2^scale) and floor(upper / 2^scale) + 1
/// (DESIGN section 3, rule 2; the paper's equation 1 on zero-aligned grids).
template <class Index>
Cells<Index> encode(float lower, float upper, int scale) {
  return {floor_on_grid<Index>(lower, scale), Index(floor_on_grid<Index>(upper, scale) + 1)};
}

/// The same interval on the grid 2^d times coarser, d >= 0: floor for the lower edge, ceil for the exclusive upper edge
/// (rule 7).
template <class Index>
Cells<Index> coarsen(const Cells<Index>& cells, int d) {
  return {floor_divide(cells.lower, d), ceil_divide(cells.upper, d)};
}

}  // namespace cbvh::golden
