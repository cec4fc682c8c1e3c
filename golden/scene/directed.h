// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cstdint>

namespace cbvh::golden {

/// The double before a finite one.
inline double next_below(double x) {
  if (x == 0) return -0x1p-1074;
  const auto bits = std::bit_cast<std::int64_t>(x);
  return std::bit_cast<double>(x > 0 ? bits - 1 : bits + 1);
}

/// a + b rounded towards minus infinity, whatever the rounding mode: what rounding to nearest lost is a double again
/// (Knuth's two-sum), and its sign says where the sum lies. Monotone in both. For |a|, |b| below 2^1022.
inline double add_down(double a, double b) {
  const double sum = a + b;
  const double of_b = sum - a;
  const double lost = (a - (sum - of_b)) + (b - of_b);
  return lost < 0 ? next_below(sum) : sum;
}

/// a + b rounded towards infinity.
inline double add_up(double a, double b) { return -add_down(-a, -b); }

}  // namespace cbvh::golden
