// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "vectors/faces/directed_float.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cbvh::vectors {
namespace {

constexpr int kFloatDigits = 24;
constexpr int kSmallestPlace = -149;  // of a float

}  // namespace

Exact exact(float x) {
  int exponent = 0;
  const double fraction = std::frexp(static_cast<double>(x), &exponent);
  const auto digits = static_cast<std::int64_t>(std::ldexp(fraction, kFloatDigits));
  return Exact(digits) * (Exact(1) << static_cast<unsigned>(exponent - kFloatDigits + kExactPlaces));
}

Exact exact_product(int cells, float x, int scale) {
  const Exact product = exact(x) * cells;  // a multiple of 2^-149
  return scale >= 0 ? Exact(product << static_cast<unsigned>(scale)) : Exact(product >> static_cast<unsigned>(-scale));
}

float largest_not_above(const Exact& value) {
  if (value == 0) return 0;
  const Exact magnitude = abs(value);
  const int highest = static_cast<int>(msb(magnitude));
  const int last = std::max(highest - kFloatDigits + 1, kSmallestPlace + kExactPlaces);  // the float's last place
  const Exact unit = Exact(1) << static_cast<unsigned>(last);
  Exact units = magnitude / unit;
  if (value < 0 && units * unit != magnitude) ++units;
  const double result = std::ldexp(static_cast<double>(static_cast<std::int64_t>(units)), last - kExactPlaces);
  constexpr double kLargest = std::numeric_limits<float>::max();
  if (value > 0) return static_cast<float>(std::min(result, kLargest));
  return result > kLargest ? -std::numeric_limits<float>::infinity() : static_cast<float>(0.0 - result);
}

}  // namespace cbvh::vectors
