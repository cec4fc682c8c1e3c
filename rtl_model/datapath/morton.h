// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_model/datapath/float_arithmetic.h"
#include "rtl_model/datapath/lbvh_payloads.h"

/// The place of a box on the Morton curve through the scene box. DESIGN 3.2, LBVH: binary32, operation by operation.
namespace cbvh::rtl {

constexpr int kMortonAxisBits = kMortonBits / 3;

/// What one axis of the scene box fixes for all primitives: computed once, when the scene box is set.
template <class Bits>
struct MortonAxis {
  typename Bits::F lower;
  typename Bits::F extent;               ///< upper - lower
  typename Bits::template U<1> quarter;  ///< that would be infinite: both bounds, and the centres, are taken times 1/4
  typename Bits::template U<1> flat;     ///< no extent: every code is 0
};

template <class Bits>
constexpr MortonAxis<Bits> morton_axis(typename Bits::F lower, typename Bits::F upper) {
  const auto extent = subtract_floats<Bits>(upper, lower);
  const auto flat = bits<31, 31>(extent) | is_zero<Bits>(extent);
  const auto quarter = Bits::corner(Corner::morton_quarter, ~flat & is_special<Bits>(extent));
  const auto quarter_lower = scale_down<Bits, 2>(lower);
  const auto quarter_extent = subtract_floats<Bits>(scale_down<Bits, 2>(upper), quarter_lower);
  return {select(quarter, quarter_lower, lower), select(quarter, quarter_extent, extent), quarter,
          Bits::corner(Corner::morton_flat, flat)};
}

/// min(1023, floor(1024 t)) of t >= 0; 0 of t < 0. The product with 1024 is exact wherever it matters.
template <class Bits>
constexpr auto morton_cell(typename Bits::F t) {
  const auto exponent = bits<30, 23>(t);
  const auto places = modulo_bits<8>(constant<Bits, 8>(140) - exponent);  // below the last one that counts
  const auto inside = truncate<kMortonAxisBits>(shift_right(significand<Bits>(t), places));
  const auto beyond = less(constant<Bits, 7>(126), exponent);
  const auto cell = select(beyond, constant<Bits, kMortonAxisBits>(1023), inside);
  return select(bits<31, 31>(t), constant<Bits, kMortonAxisBits>(0), cell);
}

/// One axis of a code: where the centre of [lower, upper] lies.
template <class Bits>
constexpr auto morton_coordinate(typename Bits::F lower, typename Bits::F upper, const MortonAxis<Bits>& axis) {
  const auto centre = add_floats<Bits>(scale_down<Bits, 1>(lower), scale_down<Bits, 1>(upper));
  const auto place = subtract_floats<Bits>(select(axis.quarter, scale_down<Bits, 2>(centre), centre), axis.lower);
  const auto cell = morton_cell<Bits>(divide_floats<Bits>(place, axis.extent));
  return select(axis.flat, constant<Bits, kMortonAxisBits>(0), cell);
}

template <class Bits>
using MortonFrame = std::array<MortonAxis<Bits>, 3>;

template <class Bits>
constexpr MortonFrame<Bits> morton_frame(const SceneBox& registers) {
  [[maybe_unused]] const typename Bits::Scope scope(Datapath::morton_frame);
  MortonFrame<Bits> frame;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    frame[axis] = morton_axis<Bits>(lift<Bits>(registers.scene.lower[axis]), lift<Bits>(registers.scene.upper[axis]));
  }
  return frame;
}

/// The code of a box; x is the most significant of each triple of bits.
template <class Bits>
constexpr UInt<kMortonBits> morton_code(const FloatBox& box, const MortonFrame<Bits>& frame) {
  [[maybe_unused]] const typename Bits::Scope scope(Datapath::morton_code);
  const auto coordinate = [&](std::size_t axis) {
    return spread_by_three(
        morton_coordinate<Bits>(lift<Bits>(box.lower[axis]), lift<Bits>(box.upper[axis]), frame[axis]));
  };
  const auto x = concat(coordinate(0), constant<Bits, 2>(0));
  const auto y = typename Bits::template U<kMortonBits>(concat(coordinate(1), constant<Bits, 1>(0)));
  const auto z = typename Bits::template U<kMortonBits>(coordinate(2));
  return lower(x | y | z);
}

}  // namespace cbvh::rtl
