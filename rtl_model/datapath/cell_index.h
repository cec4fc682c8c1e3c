// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_model/datapath/float_fields.h"

namespace cbvh::rtl {

/// floor(x / 2^scale) as a two's complement cell index; scale is not finer than x's last place.
/// Paper fig. 5, lines 7-12, corrected: rounds towards minus infinity, which for a negative number is not truncation.
template <class Bits>
constexpr typename Bits::template S<kIndexBits> cell_floor(const FloatFields<Bits>& x,
                                                           typename Bits::template S<kScaleBits> scale) {
  const auto distance = modulo_bits<9>(scale - x.place);
  const auto far = Bits::corner(Corner::axis_all_bits_dropped, less(constant<Bits, 9>(23), distance));
  const auto shift = select(far, constant<Bits, 5>(24), truncate<5>(distance));
  const auto aligned = shift_right(x.mantissa, shift);
  const auto inexact = dropped_bits(x.mantissa, shift);
  const auto round_down = Bits::corner(Corner::axis_negative_inexact, x.sign & inexact);
  const auto truncated =
      select(x.sign, checked<25>(typename Bits::template S<1>() - as_signed(aligned)), as_signed(aligned));
  return checked<kIndexBits>(truncated - round_down);
}

/// The most that upper_floor - lower_floor may be for a node to fit its grid: one cell less than it may span.
template <class Bits, int N>
constexpr auto largest_difference(typename Bits::template U<1> figure5) {
  return select(figure5, constant<Bits, N>((1u << N) - 2), constant<Bits, N>((1u << N) - 1));
}

/// How much finer than its parent's grid a node's own grid is before the minimum scale is applied. `difference` is the
/// number of cells the node spans, less one. Equation 2 is the count of leading zeros of that difference itself;
/// figures 4 and 5 shift the number of cells, and so stop one step coarser at powers of two.
template <class Bits, int N>
constexpr auto refinement(typename Bits::template U<N> difference, typename Bits::template U<1> figure5) {
  const auto cells = truncate<N>(difference + constant<Bits, 1>(1));
  return count_leading_zeros(select(figure5, cells, difference));
}

/// max(scale - finer, min_scale) and the lower index on that grid: rule 4.
template <class Bits>
struct OwnGrid {
  typename Bits::template S<kScaleBits> scale;
  typename Bits::template S<kIndexBits> lower;
};
template <class Bits, int V>
constexpr OwnGrid<Bits> own_grid(typename Bits::template S<kScaleBits> scale,
                                 typename Bits::template S<kIndexBits> lower, typename Bits::template U<V> finer,
                                 typename Bits::template S<kScaleBits> min_scale) {
  const auto wanted = scale - finer;
  const auto held =
      Bits::corner(Corner::axis_minimum_scale, less(wanted, typename Bits::template S<kScaleBits + 1>(min_scale)));
  const auto own = select(held, min_scale, truncate<kScaleBits>(wanted));
  return {own, shift_left(lower, modulo_bits<4>(scale - own))};
}

}  // namespace cbvh::rtl
