// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/build/morton.h"

#include <cmath>

namespace cbvh::golden {
namespace {

/// Bit i of a 10-bit number moves to bit 3 i.
std::uint32_t spread(std::uint32_t x) {
  x = (x | (x << 16)) & 0x030000FFU;
  x = (x | (x << 8)) & 0x0300F00FU;
  x = (x | (x << 4)) & 0x030C30C3U;
  return (x | (x << 2)) & 0x09249249U;
}

}  // namespace

std::uint32_t morton_axis(float lower, float upper, float scene_lower, float scene_upper) {
  const float centre = lower * 0.5F + upper * 0.5F;
  const float extent = scene_upper - scene_lower;
  if (!(extent > 0.0F)) return 0;
  const float t = std::isinf(extent)
                      ? ((centre * 0.25F - scene_lower * 0.25F) / (scene_upper * 0.25F - scene_lower * 0.25F)) * 1024.0F
                      : ((centre - scene_lower) / extent) * 1024.0F;
  if (!(t > 0.0F)) return 0;
  return t >= 1023.0F ? 1023 : static_cast<std::uint32_t>(t);
}

std::uint32_t morton_code(const Box& box, const Box& scene) {
  std::uint32_t code = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const std::uint32_t q = morton_axis(box.lower[axis], box.upper[axis], scene.lower[axis], scene.upper[axis]);
    code |= spread(q) << (2 - axis);
  }
  return code;
}

}  // namespace cbvh::golden
