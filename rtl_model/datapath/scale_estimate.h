// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_model/datapath/axis_compress.h"

namespace cbvh::rtl {

/// Rule 6 for one axis, exact and cheap. Both bounds become indices on the grid of the minimum scale, where nothing is
/// lost. The width of their difference gives a scale that is right or one too fine; one comparison of N-bit numbers
/// tells which. Paper section 4.1 looks at the exponent of upper - lower alone, which does not fit on 1 % of axes.
template <class Bits, int N>
constexpr EstimateResult estimate_scale(const EstimateJob& job) {
  [[maybe_unused]] const typename Bits::Scope scope(Datapath::estimate_scale);
  const auto low = break_float<Bits>(lift<Bits>(job.lower));
  const auto high = break_float<Bits>(lift<Bits>(job.upper));
  const auto min_scale = lift<Bits>(job.registers.min_scale);
  const auto figure5 = lift<Bits>(job.registers.figure5);

  const auto lower_index = cell_floor(low, min_scale);
  const auto upper_floor = cell_floor(high, min_scale);
  const auto size = modulo_bits<kIndexBits>(upper_floor - lower_index);
  // bit length of size, less N, but not below 0: the scale at which the size alone has N bits.
  const auto excess = as_signed(constant<Bits, 5>(kIndexBits - N)) - count_leading_zeros(size);
  const auto fine = select(negative(excess), constant<Bits, 5>(0), modulo_bits<5>(excess));
  const auto difference = shift_right(upper_floor, fine) - shift_right(lower_index, fine);
  const auto too_fine =
      Bits::corner(Corner::estimate_one_coarser, less(as_signed(largest_difference<Bits, N>(figure5)), difference));
  const auto coarser = fine + too_fine;
  Bits::corner(Corner::estimate_minimum_scale, ~any(coarser));

  const auto status = interval_status<Bits>(lift<Bits>(job.lower), lift<Bits>(job.upper), low, high, min_scale);
  const auto refused = any(status);
  const auto gate = [&](auto wire) { return select(refused, decltype(wire)(), wire); };
  return {lower(gate(truncate<kScaleBits>(min_scale + coarser))), lower(gate(shift_right(lower_index, coarser))),
          lower(status)};
}

}  // namespace cbvh::rtl
