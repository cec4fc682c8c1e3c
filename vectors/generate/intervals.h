// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "rtl_model/datapath/payloads.h"
#include "vectors/random.h"

/// Corners of one axis: intervals crossed with grids.
namespace cbvh::vectors {

/// The corners an interval can sit in. All are valid: finite, lower <= upper.
enum class IntervalCorner : std::size_t {
  signed_zero,               ///< bounds that are -0 or +0
  subnormal,                 ///< the smallest floats, and across the border to the normal ones
  largest_finite,            ///< bounds within a few last places of the largest float: edges of +-2^128
  sign_crossing,             ///< lower < 0 < upper
  edge_on_grid,              ///< bounds that are multiples of the cell
  one_cell,                  ///< inside one cell
  power_of_two_size,         ///< exactly 2^j cells
  full_grid,                 ///< exactly as many cells as the grid has
  degenerate_axis,           ///< lower == upper
  minimum_scale_saturation,  ///< the own grid would be finer than the minimum scale
  exponent_gap,              ///< 0..40 binary orders between the bounds, or between them and the grid
  random_bits                ///< any two finite floats
};
constexpr std::size_t kIntervalCorners = 12;

struct Interval {
  float lower;
  float upper;
  int scale;                      ///< a grid that holds it
  rtl::SceneRegisters registers;  ///< allow it
};

/// An interval of this corner, valid on its grid.
Interval make_interval(IntervalCorner corner, Random& random, int bits);

/// The same registers with e_min not below the exactness limit of `magnitude`.
rtl::SceneRegisters allowing(rtl::SceneRegisters registers, float magnitude);

/// Makes e_min finer than the exactness limit of the bounds.
rtl::SceneRegisters too_fine_for(const Interval& interval, Random& random);

/// The interval with one bound replaced by a NaN or an infinity.
Interval with_special(Interval interval, Random& random);

/// The interval with lower > upper.
Interval inverted(Interval interval, Random& random);

/// An interval, and a grid at or above e_min on which it has too many cells.
Interval make_too_wide(Random& random, int bits);

}  // namespace cbvh::vectors
