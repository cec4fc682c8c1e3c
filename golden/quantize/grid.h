// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>

namespace cbvh::golden {

/// An axis-aligned bounding box in binary32. Valid when finite and lower <= upper on every axis.
struct Box {
  glm::vec3 lower;
  glm::vec3 upper;
};

/// How many cells a node may span on its own grid: 2^N (equation 2) or 2^N - 1 (the loops of figures 4 and 5).
enum class ScaleRule : std::uint8_t { equation2, figure5 };

/// How a child's cell indices become N-bit codes (DESIGN section 3, rule 5).
enum class Code : std::uint8_t { modulo, relative };

/// What a scene fixes for all its grids.
struct GridRules {
  int bits = 6;          ///< N, bits per coordinate, 2..8
  int min_scale = -149;  ///< e_min, the finest grid exponent any node may use
  ScaleRule scale_rule = ScaleRule::equation2;

  /// The most cells a node may span.
  std::int64_t max_cells() const { return (std::int64_t{1} << bits) - (scale_rule == ScaleRule::figure5 ? 1 : 0); }
};

/// Cell indices [lower, upper) of an interval on a zero-aligned grid; `upper` is the exclusive edge (k and l of the
/// paper).
template <class Index>
struct Cells {
  Index lower;
  Index upper;
  bool operator==(const Cells&) const = default;
};

/// One axis of a traversal context: the node's own grid exponent and its own lower index on that grid.
template <class Index>
struct AxisContext {
  int scale;
  Index lower;
  bool operator==(const AxisContext&) const = default;
};

template <class Index>
using Context = std::array<AxisContext<Index>, 3>;

}  // namespace cbvh::golden
