// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "vectors/faces/box_decode.h"

#include <cstdlib>

namespace cbvh::vectors {

using rtl::Status;

DecodedAxis decode_axis(golden::AxisCodes codes, const golden::AxisContext<Index>& parent,
                        const rtl::SceneRegisters& registers, int bits) {
  constexpr int kFinestFloat = -149;
  const golden::GridRules rules = rules_of(registers, bits);
  DecodedAxis axis;
  axis.cells = golden::decode_codes(codes, parent.lower, code_of(registers), bits);
  const Index span = axis.cells.upper - axis.cells.lower;
  const bool below = parent.scale < rules.min_scale;
  const bool wide = span > rules.max_cells();
  bool inexact = rules.min_scale < kFinestFloat || std::abs(axis.cells.lower) > kLargestExactIndex ||
                 std::abs(axis.cells.upper) > kLargestExactIndex;
  if (span > 0 && !below && !wide) {
    axis.own = golden::own_context(axis.cells, parent.scale, rules);
    inexact = inexact || std::abs(axis.own.lower) > kLargestExactIndex;
  }
  if (span <= 0) {
    axis.status = Status::inverted;
  } else if (inexact) {
    axis.status = Status::beyond_exactness;
  } else if (below) {
    axis.status = Status::scale_below_minimum;
  } else if (wide) {
    axis.status = Status::too_wide;
  }
  return axis;
}

}  // namespace cbvh::vectors
