// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cstdint>

namespace cbvh::golden {

// Directed rounding without branches and without touching the rounding mode: boxes of instances are transformed by the
// million.

/// Two lanes of binary64.
using Double2 [[gnu::vector_size(16)]] = double;

/// a + b rounded towards minus infinity: what rounding to nearest lost is a double again (Knuth's two-sum), and its
/// sign says where the sum lies. Monotone in both. For sums that are zero or of a magnitude of 2^-900 .. 2^1022.
inline Double2 add_down(Double2 a, Double2 b) {
  const Double2 sum = a + b;
  const Double2 of_b = sum - a;
  const Double2 lost = (a - (sum - of_b)) + (b - of_b);
  // 5/8 to 5/4 units in the last place, rounded to nearest: exactly the double below, at powers of two as well.
  const Double2 step = (sum < 0.0 ? -sum : sum) * 0x1.4p-53;
  return sum - (lost < 0.0 ? step : Double2{});
}

/// The largest float that is not above a value (-infinity when none is finite): round_down of golden/quantize/edge.h.
inline float float_down(double value) {
  const float nearest = static_cast<float>(value) + 0.0F;
  const auto bits = std::bit_cast<std::int32_t>(nearest);
  const std::int32_t above = static_cast<double>(nearest) > value ? 1 : 0;
  if (bits == 0) return above != 0 ? -0x1p-149F : 0.0F;
  const std::int32_t below = (bits >> 31) | 1;  // bits of negative floats grow downwards
  return std::bit_cast<float>(bits - below * above);
}

}  // namespace cbvh::golden
