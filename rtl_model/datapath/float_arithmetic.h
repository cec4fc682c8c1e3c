// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_model/bits/machine_bits.h"

/// Binary32 sums, quotients and products with powers of two, rounded to nearest, ties to even: every bit as IEEE 754
/// has it, subnormals and infinities included. A NaN result is always 0x7FC00000.
namespace cbvh::rtl {

constexpr std::uint64_t kInfinityBits = 0x7F800000;  ///< without the sign
constexpr std::uint64_t kNanBits = 0x7FC00000;

template <class Bits>
constexpr auto is_special(typename Bits::F x) {
  return ~any(~bits<30, 23>(x));
}
template <class Bits>
constexpr auto is_zero(typename Bits::F x) {
  return ~any(bits<30, 0>(x));
}
template <class Bits>
constexpr auto is_nan(typename Bits::F x) {
  return is_special<Bits>(x) & any(bits<22, 0>(x));
}
/// The exponent field, but 1 for zero and subnormals: they have the last place of the smallest normal numbers.
template <class Bits>
constexpr auto effective_exponent(typename Bits::F x) {
  const auto field = bits<30, 23>(x);
  return select(any(field), field, constant<Bits, 8>(1));
}
/// The significand with its hidden bit.
template <class Bits>
constexpr auto significand(typename Bits::F x) {
  return concat(any(bits<30, 23>(x)), bits<22, 0>(x));
}

/// Packs significand * 2^(exponent - 150): its highest bit is set, or the exponent is 1. `guard` is the bit below the
/// last place, `sticky` says whether anything is set below that. Rounding up may carry into the exponent: that is how
/// it must be. The result is infinite from exponent 255 on.
template <class Bits>
constexpr auto round_magnitude(typename Bits::template U<10> exponent, typename Bits::template U<24> kept,
                               typename Bits::template U<1> guard, typename Bits::template U<1> sticky) {
  const auto normal = bits<23, 23>(kept);
  const auto field = select(normal, truncate<8>(exponent), constant<Bits, 8>(0));
  const auto rounded = concat(field, bits<22, 0>(kept)) + (guard & (sticky | bits<0, 0>(kept)));
  const auto infinite = less(constant<Bits, 8>(254), exponent);
  return select(infinite, constant<Bits, 31>(kInfinityBits), truncate<31>(rounded));
}

/// a + b.
template <class Bits>
constexpr typename Bits::F add_floats(typename Bits::F a, typename Bits::F b) {
  const auto a_is_smaller = less(bits<30, 0>(a), bits<30, 0>(b));
  const auto large = select(a_is_smaller, b, a);
  const auto small = select(a_is_smaller, a, b);
  const auto sign = bits<31, 31>(large);
  const auto opposite = differ(sign, bits<31, 31>(small));

  // Three bits below the last place are enough: only when they are aligned to within one can many bits cancel.
  const auto exponent = effective_exponent<Bits>(large);
  const auto distance = modulo_bits<8>(exponent - effective_exponent<Bits>(small));
  const auto small_places = concat(significand<Bits>(small), constant<Bits, 3>(0));
  const auto aligned =
      shift_right(small_places, distance) | typename Bits::template U<27>(dropped_bits(small_places, distance));
  const auto large_places = concat(significand<Bits>(large), constant<Bits, 3>(0));
  const auto sum = select(opposite, modulo_bits<28>(large_places - aligned), large_places + aligned);

  // One place higher, and then left as far as the smallest exponent allows.
  const auto zeros = count_leading_zeros(sum);
  const auto limited = less(exponent, zeros);
  const auto shift = select(limited, exponent, typename Bits::template U<8>(zeros));
  const auto normalised = shift_left(sum, shift);
  const auto magnitude =
      round_magnitude<Bits>(modulo_bits<10>(exponent + constant<Bits, 1>(1) - shift), bits<27, 4>(normalised),
                            bits<3, 3>(normalised), any(bits<2, 0>(normalised)));

  const auto zero = ~any(sum);
  const auto finite = concat(select(zero, sign & bits<31, 31>(small), sign), magnitude);
  const auto nan = is_nan<Bits>(large) | (opposite & is_special<Bits>(small));
  return select(nan, constant<Bits, 32>(kNanBits), select(is_special<Bits>(large), large, finite));
}

/// a - b.
template <class Bits>
constexpr typename Bits::F subtract_floats(typename Bits::F a, typename Bits::F b) {
  return add_floats<Bits>(a, concat(~bits<31, 31>(b), bits<30, 0>(b)));
}

/// x * 2^-Places.
template <class Bits, int Places>
constexpr typename Bits::F scale_down(typename Bits::F x) {
  const auto exponent = bits<30, 23>(x);
  const auto places = constant<Bits, 8>(Places);
  const auto stays_normal = less(places, exponent);
  const auto normal = concat(modulo_bits<8>(exponent - places), bits<22, 0>(x));
  // To the last place of the subnormals; what is rounded up to a normal number carries into the exponent.
  const auto shift = modulo_bits<8>(places + constant<Bits, 1>(1) - effective_exponent<Bits>(x));
  const auto kept_and_guard = shift_right(concat(significand<Bits>(x), constant<Bits, 1>(0)), shift);
  const auto sticky = dropped_bits(concat(significand<Bits>(x), constant<Bits, 1>(0)), shift);
  const auto kept = bits<24, 1>(kept_and_guard);
  const auto round_up = bits<0, 0>(kept_and_guard) & (sticky | bits<0, 0>(kept));
  const auto subnormal = typename Bits::template U<31>(kept + round_up);
  const auto scaled = concat(bits<31, 31>(x), select(stays_normal, normal, subnormal));
  const auto special = select(is_nan<Bits>(x), constant<Bits, 32>(kNanBits), x);
  return select(is_special<Bits>(x), special, scaled);
}

/// a / b.
template <class Bits>
constexpr typename Bits::F divide_floats(typename Bits::F a, typename Bits::F b) {
  // Both significands with their highest bit set: their quotient lies between 1/2 and 2.
  const auto a_zeros = count_leading_zeros(significand<Bits>(a));
  const auto b_zeros = count_leading_zeros(significand<Bits>(b));
  const auto dividend = concat(shift_left(significand<Bits>(a), a_zeros), constant<Bits, 26>(0));
  const auto divisor = shift_left(significand<Bits>(b), b_zeros);
  const auto quotient = truncate<28>(divide_with_sticky(dividend, divisor));
  const auto at_least_one = bits<27, 27>(quotient);
  const auto normalised = select(at_least_one, quotient, shift_left(quotient, constant<Bits, 1>(1)));

  const auto a_exponent = effective_exponent<Bits>(a) - a_zeros;
  const auto b_exponent = effective_exponent<Bits>(b) - b_zeros;
  const auto exponent = (a_exponent - b_exponent) + (constant<Bits, 7>(126) + at_least_one);
  const auto one = as_signed(constant<Bits, 1>(1));
  const auto too_small = less(exponent, one);
  const auto distance = select(too_small, modulo_bits<9>(one - exponent), constant<Bits, 9>(0));
  const auto places =
      shift_right(normalised, distance) | typename Bits::template U<28>(dropped_bits(normalised, distance));
  const auto magnitude = round_magnitude<Bits>(select(too_small, constant<Bits, 10>(1), modulo_bits<10>(exponent)),
                                               bits<27, 4>(places), bits<3, 3>(places), any(bits<2, 0>(places)));

  const auto a_special = is_special<Bits>(a);
  const auto b_special = is_special<Bits>(b);
  const auto a_zero = is_zero<Bits>(a);
  const auto b_zero = is_zero<Bits>(b);
  const auto nan = is_nan<Bits>(a) | is_nan<Bits>(b) | (a_special & b_special) | (a_zero & b_zero);
  const auto finite = select(a_zero | b_special, constant<Bits, 31>(0), magnitude);
  const auto quotient_magnitude = select(a_special | b_zero, constant<Bits, 31>(kInfinityBits), finite);
  const auto sign = differ(bits<31, 31>(a), bits<31, 31>(b));
  return select(nan, constant<Bits, 32>(kNanBits), concat(sign, quotient_magnitude));
}

}  // namespace cbvh::rtl
