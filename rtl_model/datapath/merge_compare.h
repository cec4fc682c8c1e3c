// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_model/bits/machine_bits.h"
#include "rtl_model/datapath/lbvh_payloads.h"

namespace cbvh::rtl {

/// What a merge sorts by: a code, or kMergeEnd behind the last one of a run.
using MergeOrder = UInt<kMortonBits + 1>;
constexpr MergeOrder kMergeEnd{std::uint64_t{1} << kMortonBits};

/// The comparator of a merge: whether the right one goes first. Of equal ones the left one does, which comes from a
/// lower run: merging is stable.
template <class Bits>
constexpr bool right_goes_first(MergeOrder left, MergeOrder right) {
  [[maybe_unused]] const typename Bits::Scope scope(Datapath::merge_compare);
  taken<Bits>(Corner::merger_tie, left == right && left != kMergeEnd);
  return bool(less(lift<Bits>(right), lift<Bits>(left)));
}

}  // namespace cbvh::rtl
