// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_model/datapath/cell_index.h"

namespace cbvh::rtl {

/// The first reason to refuse an interval on a grid, or ok. `too_wide` is asked last, by those who know the number of
/// cells.
template <class Bits>
constexpr auto interval_status(typename Bits::F lower, typename Bits::F upper, const FloatFields<Bits>& low,
                               const FloatFields<Bits>& high, typename Bits::template S<kScaleBits> min_scale) {
  const auto not_finite = Bits::corner(Corner::axis_not_finite, low.special | high.special);
  const auto inverted = Bits::corner(Corner::axis_inverted, less(order_key<Bits>(upper), order_key<Bits>(lower)));
  const auto inexact =
      Bits::corner(Corner::axis_beyond_exactness, less(min_scale, low.place) | less(min_scale, high.place));
  const auto status_of = [](Status status) { return constant<Bits, 3>(static_cast<std::uint64_t>(status)); };
  return select(not_finite, status_of(Status::not_finite),
                select(inverted, status_of(Status::inverted),
                       select(inexact, status_of(Status::beyond_exactness), status_of(Status::ok))));
}

/// One axis of one child: figure 5 with the errata of DESIGN 3.1 corrected. The +1 of the upper bound is not needed to
/// find the scale.
template <class Bits, int N>
constexpr AxisResult<N> compress_axis(const AxisJob& job) {
  [[maybe_unused]] const typename Bits::Scope scope(Datapath::compress_axis);
  const auto low = break_float<Bits>(lift<Bits>(job.lower));
  const auto high = break_float<Bits>(lift<Bits>(job.upper));
  const auto scale = lift<Bits>(job.scale);
  const auto min_scale = lift<Bits>(job.registers.min_scale);
  const auto figure5 = lift<Bits>(job.registers.figure5);

  const auto lower_index = cell_floor(low, scale);
  const auto upper_floor = cell_floor(high, scale);
  const auto upper_index = checked<kIndexBits>(upper_floor + constant<Bits, 1>(1));
  const auto difference = upper_floor - lower_index;
  const auto own =
      own_grid<Bits>(scale, lower_index, refinement<Bits, N>(modulo_bits<N>(difference), figure5), min_scale);
  Bits::corner(Corner::axis_full_grid, ~any(~modulo_bits<N>(difference)));

  const auto interval = interval_status<Bits>(lift<Bits>(job.lower), lift<Bits>(job.upper), low, high, min_scale);
  const auto below = Bits::corner(Corner::axis_scale_below_minimum, less(scale, min_scale));
  const auto wide =
      Bits::corner(Corner::axis_too_wide, less(as_signed(largest_difference<Bits, N>(figure5)), difference));
  const auto status_of = [](Status status) { return constant<Bits, 3>(static_cast<std::uint64_t>(status)); };
  const auto status = select(any(interval), interval,
                             select(below, status_of(Status::scale_below_minimum),
                                    select(wide, status_of(Status::too_wide), status_of(Status::ok))));
  const auto refused = any(status);
  const auto gate = [&](auto wire) { return select(refused, decltype(wire)(), wire); };
  return {lower(gate(modulo_bits<N>(lower_index))),
          lower(gate(modulo_bits<N>(upper_index))),
          lower(gate(own.scale)),
          lower(gate(own.lower)),
          lower_float(gate(pack_float<Bits>(lower_index, scale))),
          lower_float(gate(pack_float<Bits>(upper_index, scale))),
          lower(status)};
}

}  // namespace cbvh::rtl
