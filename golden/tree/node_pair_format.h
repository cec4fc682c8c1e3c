// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "golden/tree/compressed_tree.h"

namespace cbvh::golden {

/// The widest codes a 16-byte node pair holds; wider ones exist unpacked only.
inline constexpr int kMostPackedBits = 6;

/// A node pair as the hardware stores it: child 0 then child 1, each one little-endian 64-bit word. Bits 5..0
/// lo_x, 11..6 lo_y, 17..12 lo_z, 23..18 hi_x, 29..24 hi_y, 35..30 hi_z, 36 leaf, 63..37 pointer (DESIGN section 4; the
/// paper's section 5).
using NodePairWords = std::array<std::uint64_t, 2>;

/// Throws InputError when a code exceeds six bits or a pointer 27.
NodePairWords pack_node_pair(const CompressedPair& pair);

/// Every pair of words is some node pair.
CompressedPair unpack_node_pair(const NodePairWords& words);

}  // namespace cbvh::golden
