// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_model/datapath/float_fields.h"
#include "rtl_model/datapath/lbvh_payloads.h"

namespace cbvh::rtl {

/// The smallest box around the three vertices. Refuses a primitive with a NaN or an infinity in it. DESIGN section 3,
/// rule 1.
template <class Bits>
constexpr PrimitiveBox primitive_box(const Primitive& primitive) {
  using F = typename Bits::F;
  [[maybe_unused]] const typename Bits::Scope scope(Datapath::primitive_box);
  const auto special = [](F x) { return ~any(~bits<30, 23>(x)); };
  const auto vertex = [&](std::size_t i, std::size_t axis) { return lift<Bits>(primitive.vertex[i][axis]); };
  // Numbers alone: the sign of zero goes.
  const auto positive_zero = [](F x) { return select(any(bits<30, 0>(x)), x, constant<Bits, 32>(0)); };

  auto refused = constant<Bits, 1>(0);
  std::array<F, 3> lower_bounds;
  std::array<F, 3> upper_bounds;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const F a = vertex(0, axis);
    const F b = vertex(1, axis);
    const F c = vertex(2, axis);
    refused = refused | special(a) | special(b) | special(c);
    lower_bounds[axis] = positive_zero(smaller_float<Bits>(smaller_float<Bits>(a, b), c));
    upper_bounds[axis] = positive_zero(larger_float<Bits>(larger_float<Bits>(a, b), c));
  }
  refused = Bits::corner(Corner::primitive_not_finite, refused);

  PrimitiveBox result{{}, primitive.id, primitive.last, {}};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    result.box.lower[axis] = lower_float(select(refused, F(), lower_bounds[axis]));
    result.box.upper[axis] = lower_float(select(refused, F(), upper_bounds[axis]));
  }
  const auto status_of = [](Status status) {
    return constant<Bits, StatusBits::kWidth>(static_cast<std::uint64_t>(status));
  };
  result.status = lower(select(refused, status_of(Status::not_finite), status_of(Status::ok)));
  return result;
}

}  // namespace cbvh::rtl
