// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace cbvh::golden {

/// The indices of `keys` in ascending order, equal keys in their own; -0 equals 0. No key is NaN; fewer than 2^32.
std::vector<std::uint32_t> radix_order(std::span<const float> keys);

}  // namespace cbvh::golden
