// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstdint>

#include "golden/scene/procedural/random.h"

namespace cbvh::golden::test {

/// The golden's splitmix64 with the draws these tests need.
class Random : public golden::Random {
 public:
  using golden::Random::Random;
  int between(int low, int high) { return low + static_cast<int>(bits() % static_cast<std::uint64_t>(high - low + 1)); }
  /// Any finite float, uniform over bit patterns: subnormals and both zeros included.
  float any_float() {
    for (;;) {
      const auto x = std::bit_cast<float>(static_cast<std::uint32_t>(bits()));
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
