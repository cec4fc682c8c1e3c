// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstdint>

namespace cbvh::golden::test {

/// splitmix64.
struct Random {
  std::uint64_t state;
  std::uint64_t next() {
    std::uint64_t z = (state += 0x9E3779B97F4A7C15U);
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9U;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBU;
    return z ^ (z >> 31);
  }
  int between(int low, int high) { return low + static_cast<int>(next() % static_cast<std::uint64_t>(high - low + 1)); }
  /// Any finite float, uniform over bit patterns: subnormals and both zeros included.
  float any_float() {
    for (;;) {
      const auto x = std::bit_cast<float>(static_cast<std::uint32_t>(next()));
      if (std::isfinite(x)) return x;
    }
  }
};

using Rational = boost::multiprecision::cpp_rational;
using Integer = boost::multiprecision::cpp_int;

/// 2^e as a rational.
inline Rational two_to(int e) {
  const Integer power = Integer{1} << static_cast<unsigned>(std::abs(e));
  return e >= 0 ? Rational{power} : Rational{Integer{1}, power};
}

/// floor of a rational, by the definition: the largest integer that is not above x.
inline Integer floor_of(const Rational& x) {
  Integer n = numerator(x) / denominator(x);
  while (Rational{n} > x) --n;
  while (Rational{n + 1} <= x) ++n;
  return n;
}

}  // namespace cbvh::golden::test
