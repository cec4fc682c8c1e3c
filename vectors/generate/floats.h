// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cmath>

#include "rtl_model/bits/float32.h"
#include "vectors/random.h"

/// Floats of one kind or another.
namespace cbvh::vectors {

inline float float_of_bits(std::uint64_t bits) { return std::bit_cast<float>(static_cast<std::uint32_t>(bits)); }

inline float any_finite_float(Random& random) {
  for (;;) {
    const float x = float_of_bits(random.next());
    if (std::isfinite(x)) return x;
  }
}
inline float any_sign(float x, Random& random) { return random.flip() ? -x : x; }
/// -0 or +0.
inline float any_zero(Random& random) { return any_sign(0.0F, random); }
/// Subnormal, zero, or among the smallest normal numbers; of any magnitude there, from the last place on.
inline float any_tiny_float(Random& random) {
  return any_sign(float_of_bits(random.below(std::uint64_t{2} << random.between(0, 23))), random);
}
/// Within a few last places of the largest.
inline float any_huge_float(Random& random) { return any_sign(float_of_bits(0x7F7FFFFF - random.below(8)), random); }
/// An infinity or a NaN.
inline float any_special_float(Random& random) {
  return float_of_bits((random.flip() ? 0x7F800000 : 0x7F800000 | random.below(0x800000)) | random.below(2) << 31);
}
/// In [-size, size).
inline float float_within(float size, Random& random) { return (random.unit() * 2 - 1) * size; }

}  // namespace cbvh::vectors
