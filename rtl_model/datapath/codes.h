// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_model/datapath/cell_index.h"

namespace cbvh::rtl {

/// A modulo code as it is stored: itself, or relative to the parent's lower index. Rule 5.
template <class Bits, int N>
constexpr auto store_code(typename Bits::template U<N> modulo_code, typename Bits::template S<kIndexBits> parent_lower,
                          typename Bits::template U<1> relative) {
  return select(relative, modulo_bits<N>(modulo_code - modulo_bits<N>(parent_lower)), modulo_code);
}

template <class Bits>
struct CellPair {
  typename Bits::template S<kIndexBits> lower;
  typename Bits::template S<kIndexBits> upper;  ///< exclusive
};

/// The cells of a stored pair of codes. A span of 0 means 2^N: the condition is on the span alone, not on equal codes
/// as equation 9 prints.
template <class Bits, int N>
constexpr CellPair<Bits> decode_codes(typename Bits::template U<N> lo, typename Bits::template U<N> hi,
                                      typename Bits::template S<kIndexBits> parent_lower,
                                      typename Bits::template U<1> relative) {
  const auto base = select(relative, constant<Bits, N>(0), modulo_bits<N>(parent_lower));
  const auto r = modulo_bits<N>(lo - base);
  const auto s = modulo_bits<N>(hi - base);
  const auto full = Bits::corner(Corner::decode_full_span, ~any(s));
  return {truncate<kIndexBits>(parent_lower + as_signed(r)),
          truncate<kIndexBits>(parent_lower + as_signed(concat(full, s)))};
}

/// Cells on a grid coarser by `coarser`: floor of the lower edge, ceiling of the upper one, which is an exclusive edge
/// already. Rule 7.
template <class Bits>
constexpr CellPair<Bits> coarsen(CellPair<Bits> cells, typename Bits::template U<5> coarser) {
  const auto rounds_up = Bits::corner(Corner::coarsen_rounds_up, dropped_bits(cells.upper, coarser));
  return {shift_right(cells.lower, coarser), truncate<kIndexBits>(shift_right(cells.upper, coarser) + rounds_up)};
}

/// Whether a context change on this axis invalidates the pair that was encoded with it. Rule 9.
template <class Bits>
constexpr auto invalidates(const AxisContext& before, const AxisContext& after, typename Bits::template U<1> relative) {
  const auto scale =
      Bits::corner(Corner::child_scale_changed, differ(lift<Bits>(before.scale), lift<Bits>(after.scale)));
  const auto moved = differ(lift<Bits>(before.lower), lift<Bits>(after.lower));
  return scale | Bits::corner(Corner::child_lower_changed, relative & moved & ~scale);
}

template <class Bits>
constexpr auto invalidates(const Context& before, const Context& after, typename Bits::template U<1> relative) {
  [[maybe_unused]] const typename Bits::Scope scope(Datapath::invalidates);
  return invalidates<Bits>(before[0], after[0], relative) | invalidates<Bits>(before[1], after[1], relative) |
         invalidates<Bits>(before[2], after[2], relative);
}

}  // namespace cbvh::rtl
