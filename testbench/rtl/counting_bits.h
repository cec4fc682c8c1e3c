// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "rtl_model/bits/machine_bits.h"

namespace cbvh::testbench {

/// How often each corner of the design was taken.
using CornerCounts = std::array<std::uint64_t, rtl::kCorners>;

/// Of this thread, since the last take_corner_counts().
inline constinit thread_local CornerCounts corner_counts{};

/// Gives this thread's counts and sets them to zero.
inline CornerCounts take_corner_counts() {
  const CornerCounts counts = corner_counts;
  corner_counts = {};
  return counts;
}

#ifdef CBVH_RTL_BITS_HEADER
}  // namespace cbvh::testbench
#include CBVH_RTL_BITS_HEADER
namespace cbvh::testbench {
/// A test build puts a bit type of its own in the place of the one below.
using CountingBits = CBVH_RTL_BITS;
#else
/// Machine bits that count the corners they see taken: on the thread that simulates, so without a lock.
struct CountingBits : rtl::MachineBits {
  static U<1> corner(rtl::Corner corner, U<1> taken) {
    corner_counts[static_cast<std::size_t>(corner)] += taken.raw();
    return taken;
  }
};
#endif

}  // namespace cbvh::testbench
