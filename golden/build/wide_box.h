// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cstdint>
#include <limits>

#include "golden/quantize/grid.h"

namespace cbvh::golden {

/// x, y, z and a fourth lane, which rides along: whoever uses it keeps an ordinary float there, for arithmetic touches
/// it.
using Float4 [[gnu::vector_size(16)]] = float;
using Int4 [[gnu::vector_size(16)]] = std::int32_t;
using Double4 [[gnu::vector_size(32)]] = double;

inline Float4 lesser(Float4 a, Float4 b) { return a < b ? a : b; }
inline Float4 greater(Float4 a, Float4 b) { return a > b ? a : b; }

/// A Box in four lanes (the paper 002's section 4): what builders read and write most. Empty by default: lower
/// infinite, upper minus infinite.
struct WideBox {
  Float4 lower = Float4{} + std::numeric_limits<float>::infinity();
  Float4 upper = Float4{} - std::numeric_limits<float>::infinity();

  void enclose(const WideBox& other) {
    lower = lesser(lower, other.lower);
    upper = greater(upper, other.upper);
  }
  void enclose(Float4 point) {
    lower = lesser(lower, point);
    upper = greater(upper, point);
  }
  /// Rounded once an axis, as DESIGN 3.2 does: never overflows.
  Float4 centroid() const { return lower * 0.5F + upper * 0.5F; }
};

inline WideBox widened(const Box& box) {
  return {Float4{box.lower.x, box.lower.y, box.lower.z, 1}, Float4{box.upper.x, box.upper.y, box.upper.z, 1}};
}

inline Box narrowed(const WideBox& box) {
  return {{box.lower[0], box.lower[1], box.lower[2]}, {box.upper[0], box.upper[1], box.upper[2]}};
}

/// half_area(narrowed(box)).
inline double half_area(const WideBox& box) {
  const Double4 extent = __builtin_convertvector(box.upper, Double4) - __builtin_convertvector(box.lower, Double4);
  const Double4 next = __builtin_shufflevector(extent, extent, 1, 2, 0, 3);
  const Double4 faces = extent * next;
  return faces[0] + faces[1] + faces[2];
}

/// The axis on which a box is longest, the first of equals.
inline int longest_axis(const WideBox& box) {
  const auto extent = [&](int axis) {
    return static_cast<double>(box.upper[axis]) - static_cast<double>(box.lower[axis]);
  };
  int longest = 0;
  for (int axis = 1; axis < 3; ++axis) {
    if (extent(axis) > extent(longest)) longest = axis;
  }
  return longest;
}

/// What a builder sorts: a box with the ID of its primitive in a fourth lane, as the bits of a float in [2, 2^17).
class Reference {
 public:
  Reference() = default;
  /// id < 2^27 (kMaxCount).
  Reference(const Box& box, std::uint32_t id) : box_(widened(box)) { box_.lower[3] = std::bit_cast<float>(id | kTag); }

  const WideBox& box() const { return box_; }
  std::uint32_t id() const { return std::bit_cast<std::uint32_t>(static_cast<float>(box_.lower[3])) & ~kTag; }

 private:
  static constexpr std::uint32_t kTag = 1U << 30;
  WideBox box_;
};

}  // namespace cbvh::golden
