// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "golden/quantize/grid.h"

namespace cbvh::golden {

/// One axis of a Morton code, 0..1023: where the centre of [lower, upper] lies in [scene_lower, scene_upper], in
/// binary32 rounded to nearest, operation by operation as DESIGN 3.2 writes it.
std::uint32_t morton_axis(float lower, float upper, float scene_lower, float scene_upper);

/// The 30-bit Morton code of a box's centre; x is the most significant of each triple of bits.
std::uint32_t morton_code(const Box& box, const Box& scene);

}  // namespace cbvh::golden
