// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "golden/build/float_tree.h"

namespace cbvh::golden {

/// A node pair in binary32 as hardware without compression stores it: 64 bytes, child 0 then child 1, little-endian
/// words. Of each child lower x y z, upper x y z, pointer | leaf << 31, zero.
using FloatPairWords = std::array<std::uint32_t, 16>;

/// Throws InputError when a pointer exceeds 27 bits.
FloatPairWords pack_float_pair(const FloatPair& pair);

}  // namespace cbvh::golden
