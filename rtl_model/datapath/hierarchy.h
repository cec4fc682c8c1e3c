// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_model/datapath/float_fields.h"
#include "rtl_model/datapath/lbvh_payloads.h"

namespace cbvh::rtl {

/// The smallest box around both. Of equal coordinates the first box's is taken.
template <class Bits>
constexpr FloatBox unite_boxes(const FloatBox& a, const FloatBox& b) {
  [[maybe_unused]] const typename Bits::Scope scope(Datapath::unite_boxes);
  FloatBox both;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    both.lower[axis] = lower_float(smaller_float<Bits>(lift<Bits>(a.lower[axis]), lift<Bits>(b.lower[axis])));
    both.upper[axis] = lower_float(larger_float<Bits>(lift<Bits>(a.upper[axis]), lift<Bits>(b.upper[axis])));
  }
  return both;
}

/// How many leading bits two codes share: 30 if they are equal, otherwise they differ first at bit 29 - prefix.
template <class Bits>
constexpr PrefixLength common_prefix(UInt<kMortonBits> first, UInt<kMortonBits> second) {
  [[maybe_unused]] const typename Bits::Scope scope(Datapath::common_prefix);
  const auto a = lift<Bits>(first);
  const auto b = lift<Bits>(second);
  return lower(count_leading_zeros((a & ~b) | (~a & b)));
}

}  // namespace cbvh::rtl
