// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "vectors/faces/axis.h"

/// The golden's answer for one axis of a stored child, in plain numbers.
namespace cbvh::vectors {

struct DecodedAxis {
  rtl::Status status = rtl::Status::ok;
  Cells<Index> cells{};              ///< on the parent's grid; this and what follows is valid when the status is ok
  golden::AxisContext<Index> own{};  ///< rule 4
};

/// The largest magnitude of an index whose edge is a binary32 on every grid from 2^-149 on.
constexpr Index kLargestExactIndex = Index{1} << 24;

/// Rules 5 and 4. Refused, the first that applies: inverted (not at least one cell), beyond_exactness (e_min below
/// -149, an edge's index or the own lower index beyond kLargestExactIndex), scale_below_minimum, too_wide. A grid that
/// is refused for its scale or its span has no own index to be judged.
DecodedAxis decode_axis(golden::AxisCodes codes, const golden::AxisContext<Index>& parent,
                        const rtl::SceneRegisters& registers, int bits);

}  // namespace cbvh::vectors
