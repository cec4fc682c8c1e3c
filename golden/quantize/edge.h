// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "golden/quantize/exact.h"

namespace cbvh::golden {

/// The largest float that is not above `value` (-infinity when none is finite).
inline float round_down(double value) {
  constexpr float kMax = std::numeric_limits<float>::max();
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  if (value > kMax) return kMax;
  if (value < -kMax) return -kInfinity;
  const float nearest = static_cast<float>(value);
  return static_cast<double>(nearest) > value ? std::nextafter(nearest, -kInfinity) : nearest;
}

/// index * 2^scale rounded down to a float.
inline float edge_down(std::int64_t index, int scale) {
  if (index >= -(std::int64_t{1} << 53) && index <= (std::int64_t{1} << 53)) {
    return round_down(static_cast<double>(index) * power_of_two(scale)) + 0.0F;
  }
  return edge_down(floor_divide(index, 10), scale + 10);  // a float keeps fewer bits, and floors nest
}
inline float edge_down(const Wide& index, int scale) {
  const Wide magnitude = abs(index);
  const int d = magnitude == 0 ? 0 : std::max(0, static_cast<int>(msb(magnitude)) - 50);
  return edge_down(static_cast<std::int64_t>(floor_divide(index, d)), scale + d);
}

/// index * 2^scale rounded up to a float.
inline float edge_up(std::int64_t index, int scale) { return -edge_down(-index, scale) + 0.0F; }
inline float edge_up(const Wide& index, int scale) { return -edge_down(Wide{-index}, scale) + 0.0F; }

/// index * 2^scale as the float it is; +-2^128 is +-infinity. Throws std::logic_error when no float equals it, which
/// cannot happen on grids at or above the exactness limit (DESIGN section 3, rule 3; the paper's equation 3 on
/// zero-aligned grids).
template <class Index>
float edge(const Index& index, int scale) {
  const float down = edge_down(index, scale);
  const float up = edge_up(index, scale);
  if (down == up) return down;
  const auto is_two_to_128 = [scale](const Index& magnitude) {
    return 128 - scale < std::numeric_limits<Index>::digits && magnitude == Index{1}
                                                                                << static_cast<unsigned>(128 - scale);
  };
  if (std::isinf(up) && scale <= 128 && is_two_to_128(index)) return up;
  if (std::isinf(down) && scale <= 128 && is_two_to_128(Index{-index})) return down;
  throw std::logic_error("edge: no float equals this multiple of the grid's cell");
}

}  // namespace cbvh::golden
