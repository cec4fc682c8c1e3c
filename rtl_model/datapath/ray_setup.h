// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_model/datapath/directed_float.h"
#include "rtl_model/datapath/ray_payloads.h"

namespace cbvh::rtl {

/// 1 / |d| rounded both ways. d is finite and not zero.
template <class Bits>
struct Reciprocal {
  typename Bits::F down;  ///< the largest finite binary32 at most
  typename Bits::F up;    ///< infinite from 2^128 on
};
template <class Bits>
constexpr Reciprocal<Bits> reciprocal(typename Bits::F d) {
  using Top = typename Bits::template S<kTopBits>;
  const auto divisor = normalise_float<Bits>(break_float<Bits>(d));
  // 2^47 over 2^23..2^24 - 1: 2^23 < quotient <= 2^24, with a bit for what remains below it.
  const auto quotient = truncate<26>(divide_with_sticky(constant<Bits, 48>(std::uint64_t{1} << 47), divisor.magnitude));
  const auto zeros = count_leading_zeros(quotient);
  // The bit of the quotient's 2^24 is worth 2^(1 - top).
  const auto top = truncate<kTopBits>(as_signed(constant<Bits, 2>(2)) - divisor.top - zeros);
  const Normalised<Bits, 26> value{shift_left(quotient, zeros), Top(top)};
  const auto none = constant<Bits, 1>(0);
  const auto one = constant<Bits, 1>(1);
  return {concat(none, round_to_float<Bits, 26>(value, none, none)),
          concat(none, round_to_float<Bits, 26>(value, none, one))};
}

/// A bound of the root's box on its side: finite, or infinite away from the box.
template <class Bits>
constexpr auto refused_bound(typename Bits::F bound, typename Bits::template U<1> upper_side) {
  return is_special<Bits>(bound) & (any(bits<22, 0>(bound)) | ~differ(bits<31, 31>(bound), upper_side));
}

/// The distance to a plane `offset` away: rounded down with the reciprocal that is too small, or too large if the plane
/// lies behind.
template <class Bits>
constexpr typename Bits::F distance_down(typename Bits::F offset, const Reciprocal<Bits>& inverse,
                                         typename Bits::template U<1> parallel) {
  const auto product = multiply_down<Bits>(offset, select(bits<31, 31>(offset), inverse.up, inverse.down));
  return select(parallel, offset, product);
}

/// A ray against the planes of the root's box.
template <class Bits>
constexpr RaySetupResult ray_setup(const RaySetupJob& job) {
  [[maybe_unused]] const typename Bits::Scope scope(Datapath::ray_setup);
  auto not_finite = constant<Bits, 1>(0);
  auto inverted = constant<Bits, 1>(0);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto lower_bound = lift<Bits>(job.root.lower[axis]);
    const auto upper_bound = lift<Bits>(job.root.upper[axis]);
    not_finite = not_finite | is_special<Bits>(lift<Bits>(job.origin[axis])) |
                 is_special<Bits>(lift<Bits>(job.direction[axis])) |
                 refused_bound<Bits>(lower_bound, constant<Bits, 1>(0)) |
                 refused_bound<Bits>(upper_bound, constant<Bits, 1>(1));
    inverted = inverted | less(order_key<Bits>(upper_bound), order_key<Bits>(lower_bound));
  }
  not_finite = Bits::corner(Corner::setup_not_finite, not_finite);
  inverted = Bits::corner(Corner::setup_inverted, inverted & ~not_finite);
  const auto refused = not_finite | inverted;
  const auto gate = [&](auto wire) { return select(refused, decltype(wire)(), wire); };
  const auto status_of = [](Status status) { return constant<Bits, 3>(static_cast<std::uint64_t>(status)); };

  RaySetupResult result;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto origin = lift<Bits>(job.origin[axis]);
    const auto direction = lift<Bits>(job.direction[axis]);
    const auto parallel = Bits::corner(Corner::setup_parallel, ~any(bits<30, 0>(direction)));
    const auto backwards = Bits::corner(Corner::setup_backwards, bits<31, 31>(direction) & ~parallel);
    const auto one = constant<Bits, 32>(0x3F800000);
    const auto inverse = reciprocal<Bits>(select(parallel, one, direction));
    const auto flip = [&](typename Bits::F x) { return select(backwards, negate_float<Bits>(x), x); };
    // Along the ray: the origin, the plane it enters through, and the one it leaves through.
    const auto from = flip(origin);
    const auto near_plane = flip(select(backwards, lift<Bits>(job.root.upper[axis]), lift<Bits>(job.root.lower[axis])));
    const auto far_plane = flip(select(backwards, lift<Bits>(job.root.lower[axis]), lift<Bits>(job.root.upper[axis])));
    const auto near = distance_down<Bits>(subtract_down<Bits>(near_plane, from), inverse, parallel);
    const auto far = negate_float<Bits>(distance_down<Bits>(
        subtract_down<Bits>(negate_float<Bits>(far_plane), negate_float<Bits>(from)), inverse, parallel));
    result.ray[axis] = {lower_float(gate(inverse.down)), lower(gate(backwards)), lower(gate(parallel))};
    result.planes[axis] = {lower_float(gate(near)), lower_float(gate(far))};
  }
  result.status = lower(select(not_finite, status_of(Status::not_finite),
                               select(inverted, status_of(Status::inverted), status_of(Status::ok))));
  return result;
}

}  // namespace cbvh::rtl
