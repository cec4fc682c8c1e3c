// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "golden/build/split.h"
#include "golden/options/options.h"

namespace cbvh::golden {

/// The options that builders share, under the same names everywhere.
struct BuildLimits {
  std::uint64_t leaf = 4;   ///< most primitives a leaf
  int depth = 32;           ///< most levels of inner nodes: the hardware's context stack has 32 entries
  double traversal = 1;     ///< C_T of the SAH, the cost of an inner node
  double intersection = 1;  ///< C_I of the SAH, the cost of a primitive
  int threads = 1;          ///< a result never depends on it

  /// Whether a subtree of that many primitives can be built with `levels` levels of inner nodes.
  bool fit(std::uint64_t primitives, int levels) const {
    return levels >= 27 || primitives <= leaf << static_cast<unsigned>(levels);
  }
  /// Whether a node with `levels` left becomes a leaf rather than be split at `split_cost`: half area times count, of
  /// both halves. 0 asks whether no split can be better.
  bool prefer_leaf(std::uint64_t primitives, int levels, double half_area, double split_cost) const {
    if (primitives > leaf) return false;
    return primitives == 1 || levels == 0 ||
           intersection * static_cast<double>(primitives) * half_area <=
               traversal * half_area + intersection * split_cost;
  }
  /// Whether a node that has `levels` left, at least 1, may be split into so many primitives each. Splitting at the
  /// object median always fits if the node itself fits.
  bool fit(std::uint64_t left, std::uint64_t right, int levels) const {
    return fit(left > right ? left : right, levels - 1);
  }
  /// Whether such a node is split there rather than at the object median: an area to judge by, a split, and halves that
  /// fit.
  bool usable(const Split& split, double half_area, std::uint64_t primitives, int levels) const {
    return half_area > 0 && split.exists() && fit(split.left, primitives - split.left, levels);
  }
};

/// leaf, depth, traversal, intersection.
std::vector<Option> limit_options();
Option threads_option();

/// What limit_options and threads_option (if `values` has it) say. Throws InputError at `place` when `primitives` do
/// not fit `depth` levels.
BuildLimits build_limits(const OptionValues& values, std::uint64_t primitives, const std::string& place);

}  // namespace cbvh::golden
