// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "rtl_model/datapath/float_arithmetic.h"
#include "rtl_model/datapath/float_fields.h"

/// Binary32 arithmetic that rounds towards minus infinity: the result is the largest binary32, infinities included,
/// that is not above the exact value, and never -0. Rounding up is rounding the negated value down.
namespace cbvh::rtl {

constexpr std::uint64_t kLargestFiniteBits = 0x7F7FFFFF;
constexpr int kTopBits = 11;  ///< places of the highest bits of sums and products

/// -x; 0 of 0.
template <class Bits>
constexpr typename Bits::F negate_float(typename Bits::F x) {
  const auto zero = ~any(bits<30, 0>(x));
  return select(zero, constant<Bits, 32>(0), concat(~bits<31, 31>(x), bits<30, 0>(x)));
}

/// A magnitude whose highest bit is set, unless it is zero, and the place above that bit.
template <class Bits, int W>
struct Normalised {
  typename Bits::template U<W> magnitude;
  typename Bits::template S<kTopBits> top;  ///< the lowest place there is, of zero
};
template <class Bits, int W>
constexpr Normalised<Bits, W> normalise(typename Bits::template U<W> magnitude,
                                        typename Bits::template S<kTopBits - 1> place) {
  using Top = typename Bits::template S<kTopBits>;
  const auto zeros = count_leading_zeros(magnitude);
  const auto top = truncate<kTopBits>(place + (as_signed(constant<Bits, 6>(W)) - zeros));
  const auto lowest = Top::of_raw(std::uint64_t{1} << (kTopBits - 1));
  return {shift_left(magnitude, zeros), select(any(magnitude), top, lowest)};
}

/// A normalised magnitude of at least 25 bits, rounded to the 24 of a binary32, or fewer if it is subnormal: towards
/// zero, or away from it. `below`: something remains below it. Zero stays zero.
template <class Bits, int W>
constexpr auto round_to_float(const Normalised<Bits, W>& value, typename Bits::template U<1> below,
                              typename Bits::template U<1> away) {
  using Top = typename Bits::template S<kTopBits>;
  const auto subnormal_top = Top::of_raw(static_cast<std::uint64_t>(-125));
  const auto subnormal =
      Bits::corner(Corner::directed_subnormal, less(value.top, subnormal_top) & any(value.magnitude));
  const auto lowered = modulo_bits<kTopBits>(subnormal_top - value.top);
  const auto distance = select(subnormal, lowered, constant<Bits, kTopBits>(0));
  const auto leading = bits<W - 1, W - 24>(value.magnitude);
  const auto kept = shift_right(leading, distance);
  const auto inexact = below | any(bits<W - 25, 0>(value.magnitude)) | dropped_bits(leading, distance);
  const auto rounded = kept + (inexact & away);
  // The hidden bit, or a carry into it, counts the exponent field up by one.
  const auto field = modulo_bits<kTopBits>(select(subnormal, subnormal_top, value.top) + constant<Bits, 7>(125));
  const auto packed = concat(field, constant<Bits, 23>(0)) + rounded;
  const auto nonzero = any(value.magnitude);
  const auto beyond =
      Bits::corner(Corner::directed_beyond_largest, less(constant<Bits, 31>(kLargestFiniteBits), packed) & nonzero);
  const auto limit = select(away, constant<Bits, 31>(kInfinityBits), constant<Bits, 31>(kLargestFiniteBits));
  const auto magnitude = select(beyond, limit, truncate<31>(packed));
  return select(nonzero, magnitude, constant<Bits, 31>(0));
}

/// The same with a sign, rounded towards minus infinity.
template <class Bits, int W>
constexpr typename Bits::F round_down(typename Bits::template U<1> sign, const Normalised<Bits, W>& value) {
  const auto magnitude = round_to_float<Bits, W>(value, constant<Bits, 1>(0), sign);
  return concat(sign & any(magnitude), magnitude);
}

/// (-1)^sign * x * 2^place_x + (-1)^negative * y * 2^place_y, rounded once. The larger summand is exact in a window
/// three bits wider than both; if the smaller one reaches below, the two are too far apart to cancel, and its floor
/// there is enough.
template <class Bits, int A, int B>
constexpr typename Bits::F add_down(typename Bits::template U<1> x_sign, const Normalised<Bits, A>& x,
                                    typename Bits::template U<1> y_sign, const Normalised<Bits, B>& y) {
  constexpr int kWindow = std::max(A, B) + 3;
  const auto top = select(less(x.top, y.top), y.top, x.top);
  const auto in_window = [&]<int W>(typename Bits::template U<1> sign, const Normalised<Bits, W>& value) {
    using Signed = typename Bits::template S<kWindow + 1>;
    const auto wide = as_signed(concat(value.magnitude, constant<Bits, kWindow - W>(0)));
    return shift_right(select(sign, checked<kWindow + 1>(Signed() - wide), wide),
                       modulo_bits<kTopBits>(top - value.top));
  };
  const auto sum = in_window(x_sign, x) + in_window(y_sign, y);
  const auto sign = negative(sum);
  const auto magnitude =
      modulo_bits<kWindow + 1>(select(sign, checked<kWindow + 2>(typename Bits::template S<1>() - sum), sum));
  const auto zeros = count_leading_zeros(magnitude);
  const auto raised = truncate<kTopBits>(top + (as_signed(constant<Bits, 1>(1)) - zeros));
  return round_down<Bits, kWindow + 1>(sign, {shift_left(magnitude, zeros), raised});
}

template <class Bits>
constexpr auto normalise_float(const FloatFields<Bits>& x) {
  return normalise<Bits, 24>(x.mantissa, typename Bits::template S<kTopBits - 1>(x.place));
}

/// x + cells * inverse * 2^scale: the plane that many cells further along the ray. One multiplication of 24 by N + 1
/// bits. Paper eq. 5. An infinite x stays.
template <class Bits, int W>
constexpr typename Bits::F advance_down(typename Bits::F x, typename Bits::template U<W> cells,
                                        const FloatFields<Bits>& inverse, typename Bits::template S<kScaleBits> scale) {
  const auto from = break_float<Bits>(x);
  const auto step = normalise<Bits, W + 24>(cells * inverse.mantissa, inverse.place + scale);
  const auto sum = add_down<Bits>(from.sign, normalise_float<Bits>(from), constant<Bits, 1>(0), step);
  return select(from.special, x, sum);
}

/// a - b; an infinite a stays, b is finite.
template <class Bits>
constexpr typename Bits::F subtract_down(typename Bits::F a, typename Bits::F b) {
  const auto x = break_float<Bits>(a);
  const auto y = break_float<Bits>(b);
  const auto difference = add_down<Bits>(x.sign, normalise_float<Bits>(x), ~y.sign, normalise_float<Bits>(y));
  return select(x.special, a, difference);
}

/// x * factor, factor > 0 or x nonzero; infinite if one of them is.
template <class Bits>
constexpr typename Bits::F multiply_down(typename Bits::F x, typename Bits::F factor) {
  const auto a = break_float<Bits>(x);
  const auto b = break_float<Bits>(factor);
  const auto product = normalise<Bits, 48>(a.mantissa * b.mantissa, a.place + b.place);
  const auto infinite = concat(a.sign, constant<Bits, 31>(kInfinityBits));
  return select(a.special | b.special, infinite, round_down<Bits, 48>(a.sign, product));
}

}  // namespace cbvh::rtl
