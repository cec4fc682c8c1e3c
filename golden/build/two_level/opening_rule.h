// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "golden/build/two_level/opener.h"

namespace cbvh::golden {

/// Which references of a segment are opened (Benthin et al., sections 4.2 and 4.4), and in which order the space goes.
struct OpeningRule {
  enum class Order : std::uint8_t {
    extent,   ///< the paper's: all that are wide enough, as they lie in the segment
    overlap,  ///< of those the ones whose box meets another instance's; looked at in segments of at most kWindow
    cost,     ///< all that are wide enough, the largest product of half area and primitives first
  };
  static constexpr std::size_t kWindow = 64;

  double extent = 0.1;   ///< wider than this share of the segment's longest axis
  double overlap = 0.1;  ///< of at most four references: no opening if the boxes that pairs of different instances
                         ///< share have together at most this share of the segment's half area
  Order order = Order::extent;

  /// Whether opening ends here and below: one instance only, or few references with little overlap.
  bool ends(std::span<const BuildReference> segment, const WideBox& bounds) const;

  /// A reference wider than that along the axis is worth opening.
  double least_extent(const WideBox& bounds, int axis) const;

  /// Indices of the references to open, in order.
  void choose(std::span<const BuildReference> segment, const WideBox& bounds, const Opener& opener,
              std::vector<std::uint32_t>& chosen) const;

  /// How many references meet the criterion of extent.
  std::uint32_t candidates(std::span<const BuildReference> segment, const WideBox& bounds, const Opener& opener) const;
};

}  // namespace cbvh::golden
