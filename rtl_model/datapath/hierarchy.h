// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_model/datapath/box_union.h"
#include "rtl_model/datapath/lbvh_payloads.h"

namespace cbvh::rtl {

/// How many leading bits two codes share: 30 if they are equal, otherwise they differ first at bit 29 - prefix.
template <class Bits>
constexpr PrefixLength common_prefix(UInt<kMortonBits> first, UInt<kMortonBits> second) {
  [[maybe_unused]] const typename Bits::Scope scope(Datapath::common_prefix);
  const auto a = lift<Bits>(first);
  const auto b = lift<Bits>(second);
  return lower(count_leading_zeros((a & ~b) | (~a & b)));
}

}  // namespace cbvh::rtl
