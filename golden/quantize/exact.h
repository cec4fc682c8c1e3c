// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <boost/multiprecision/cpp_int.hpp>
#include <cstdint>
#include <limits>

namespace cbvh::golden {

/// Cell indices finer than the exactness limit: |index| <= 2^277 (2^128 on a grid of 2^-149), so 512 bits never
/// overflow.
using Wide = boost::multiprecision::number<
    boost::multiprecision::cpp_int_backend<512, 512, boost::multiprecision::signed_magnitude,
                                           boost::multiprecision::unchecked, void>,
    boost::multiprecision::et_off>;

/// 2^exponent, exactly; -1022 <= exponent <= 1023.
inline double power_of_two(int exponent) {
  return std::bit_cast<double>(static_cast<std::uint64_t>(exponent + 1023) << 52);
}

/// floor(log2(x)) of a positive, normal double (every positive float, subnormals included, is one).
inline int floor_log2(double x) { return static_cast<int>(std::bit_cast<std::uint64_t>(x) >> 52) - 1023; }

/// floor(x) as a double, exact for every finite x; no library call.
inline double exact_floor(double x) {
  if (!(x > -0x1p52 && x < 0x1p52)) return x;  // an integer already
  const double truncated = static_cast<double>(static_cast<std::int64_t>(x));
  return truncated > x ? truncated - 1.0 : truncated;
}

/// index * 2^d, d >= 0. The caller knows that it fits.
template <class Index>
Index times_power_of_two(const Index& index, int d) {
  return index * (Index{1} << static_cast<unsigned>(d));
}

/// floor(index / 2^d), d >= 0, also for negative indices.
template <class Index>
Index floor_divide(const Index& index, int d) {
  if (d >= std::numeric_limits<Index>::digits - 1) return index < 0 ? Index{-1} : Index{0};
  const Index divisor = Index{1} << static_cast<unsigned>(d);
  const Index quotient = index / divisor;  // towards zero
  return quotient * divisor > index ? Index{quotient - 1} : quotient;
}

/// ceil(index / 2^d), d >= 0, also for negative indices.
template <class Index>
Index ceil_divide(const Index& index, int d) {
  return -floor_divide(Index{-index}, d);
}

/// index modulo 2^bits, in 0..2^bits - 1 also for negative indices (the paper's equation 8).
template <class Index>
std::int64_t modulo(const Index& index, int bits) {
  return static_cast<std::int64_t>(Index{index - times_power_of_two(floor_divide(index, bits), bits)});
}
inline std::int64_t modulo(std::int64_t index, int bits) { return index & ((std::int64_t{1} << bits) - 1); }

}  // namespace cbvh::golden
