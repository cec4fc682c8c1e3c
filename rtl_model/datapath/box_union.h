// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_model/datapath/float_fields.h"

namespace cbvh::rtl {

/// The smallest box around both.
template <class Bits>
constexpr FloatBox unite_boxes(const FloatBox& a, const FloatBox& b) {
  [[maybe_unused]] const typename Bits::Scope scope(Datapath::unite_boxes);
  FloatBox result;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    result.lower[axis] = lower_float(smaller_float<Bits>(lift<Bits>(a.lower[axis]), lift<Bits>(b.lower[axis])));
    result.upper[axis] = lower_float(larger_float<Bits>(lift<Bits>(a.upper[axis]), lift<Bits>(b.upper[axis])));
  }
  return result;
}

}  // namespace cbvh::rtl
