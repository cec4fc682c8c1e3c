// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_model/bits/machine_bits.h"
#include "rtl_model/datapath/payloads.h"

namespace cbvh::rtl {

/// A binary32 taken apart. Its magnitude is mantissa * 2^place; subnormals need no case of their own.
template <class Bits>
struct FloatFields {
  typename Bits::template U<1> sign;
  typename Bits::template U<24> mantissa;       ///< with the hidden bit
  typename Bits::template S<kScaleBits> place;  ///< exponent of the last place, -149..105
  typename Bits::template U<1> special;         ///< NaN or infinity
};

/// Paper fig. 5, lines 1-5.
template <class Bits>
constexpr FloatFields<Bits> break_float(typename Bits::F x) {
  const auto exponent = bits<30, 23>(x);
  const auto normal = any(exponent);
  const auto effective = select(normal, exponent, constant<Bits, 8>(1));
  return {bits<31, 31>(x), concat(normal, bits<22, 0>(x)),
          truncate<kScaleBits>(as_signed(effective) - constant<Bits, 8>(150)), ~any(~exponent)};
}

/// An integer that orders like the number x is: -0 equals 0.
template <class Bits>
constexpr auto order_key(typename Bits::F x) {
  const auto magnitude = as_signed(bits<30, 0>(x));
  const auto zero = typename Bits::template S<32>();
  return select(bits<31, 31>(x), checked<32>(zero - magnitude), magnitude);
}

template <class Bits>
constexpr auto smaller_float(typename Bits::F a, typename Bits::F b) {
  return select(less(order_key<Bits>(b), order_key<Bits>(a)), b, a);
}
template <class Bits>
constexpr auto larger_float(typename Bits::F a, typename Bits::F b) {
  return select(less(order_key<Bits>(a), order_key<Bits>(b)), b, a);
}

/// index * 2^scale as a binary32; exact, or infinite from 2^128 on. |index| <= 2^24, scale >= -149. Paper fig. 5, lines
/// 30-40.
template <class Bits>
constexpr typename Bits::F pack_float(typename Bits::template S<kIndexBits> index,
                                      typename Bits::template S<kScaleBits> scale) {
  using U25 = typename Bits::template U<25>;
  using S10 = typename Bits::template S<kScaleBits + 1>;
  const auto sign = negative(index);
  const auto magnitude =
      modulo_bits<25>(select(sign, checked<kIndexBits>(typename Bits::template S<1>() - index), index));
  const auto zeros = count_leading_zeros(magnitude);  // 0..25
  // The exponent field of a normal result: scale + 24 - zeros + 127.
  const auto field = scale + (as_signed(constant<Bits, 8>(151)) - zeros);
  const auto normal = less(S10(), truncate<kScaleBits + 1>(field));
  // A subnormal result has its last place at 2^-149; a normal one has its highest bit at bit 24.
  const auto to_last_place = modulo_bits<5>(scale + constant<Bits, 8>(149));
  const U25 aligned = select(normal, shift_left(magnitude, zeros), shift_left(magnitude, to_last_place));
  const auto fraction = select(normal, bits<23, 1>(aligned), bits<22, 0>(aligned));
  const auto infinite =
      Bits::corner(Corner::axis_edge_infinite,
                   any(magnitude) & less(as_signed(constant<Bits, 9>(254)), typename Bits::template S<12>(field)));
  const auto zero = ~any(magnitude);
  const auto subnormal = Bits::corner(Corner::axis_edge_subnormal, ~normal & ~zero);
  const auto exponent = select(subnormal | zero, constant<Bits, 8>(0), modulo_bits<8>(field));
  const auto finite = concat(exponent, fraction);
  return concat(sign, select(infinite, constant<Bits, 31>(0x7F800000), select(zero, constant<Bits, 31>(0), finite)));
}

}  // namespace cbvh::rtl
