// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace cbvh::golden {

// Directed rounding without branches and without touching the rounding mode: boxes of instances are transformed by the
// million.

/// Two lanes of binary64.
using Double2 [[gnu::vector_size(16)]] = double;
using Long2 [[gnu::vector_size(16)]] = std::int64_t;

/// a + b rounded towards minus infinity: what rounding to nearest lost is a double again (Knuth's two-sum), and its
/// sign says where the sum lies. Monotone in both. For sums that are zero or of a magnitude of 2^-900 .. 2^1022.
inline Double2 add_down(Double2 a, Double2 b) {
  const Double2 sum = a + b;
  const Double2 of_b = sum - a;
  const Double2 lost = (a - (sum - of_b)) + (b - of_b);
  // 5/8 to 5/4 units in the last place, rounded to nearest: exactly the double below, at powers of two as well.
  const Double2 magnitude = std::bit_cast<Double2>(std::bit_cast<Long2>(sum) & INT64_MAX);
  const Double2 step = magnitude * 0x1.4p-53;
  return sum - std::bit_cast<Double2>(std::bit_cast<Long2>(step) & (lost < 0.0));
}

/// In each lane, the largest float that is not above the value (-infinity when none is finite): round_down of
/// golden/quantize/edge.h.
inline std::array<float, 2> floats_down(Double2 values) {
  const std::array<float, 2> nearest{static_cast<float>(values[0]) + 0.0F, static_cast<float>(values[1]) + 0.0F};
  const Long2 above = Double2{nearest[0], nearest[1]} > values;  // -1 where it is
  const auto down = [&](std::size_t lane) {
    const auto bits = std::bit_cast<std::int32_t>(nearest[lane]);
    const auto step = static_cast<std::int32_t>(above[lane]);
    if (bits == 0) return step < 0 ? -0x1p-149F : 0.0F;
    return std::bit_cast<float>(bits + ((bits >> 31) | 1) * step);  // the bits of negative floats grow downwards
  };
  return {down(0), down(1)};
}

}  // namespace cbvh::golden
