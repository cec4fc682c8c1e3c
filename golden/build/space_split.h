// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "golden/build/build_limits.h"
#include "golden/build/float_tree.h"

namespace cbvh::golden {

/// What the builders of paper 001 that split triangles differ in.
struct SpaceRules {
  bool tight = true;     ///< a node's box is its pieces'; otherwise the cell that planes cut out, as in a k-d tree
  bool objects = false;  ///< also the best split by centroids, and the cheaper of both
  bool exact_costs =
      false;        ///< costs of the sides' tight boxes (section 5.2), not of what the plane leaves of the node
  double gain = 0;  ///< how much cheaper a plane has to be than what it replaces, as a fraction
  std::uint64_t references = kMaxCount;  ///< the most; never fewer than triangles
};

/// A tree by splitting space. A node whose best split does not fit the levels left, or the references it may still
/// add, is split by objects, at the cheapest centroid that fits, or at the object median. References
/// that may be added are shared among a node's halves in proportion to their pieces. A node that no split makes cheaper
/// is a leaf if it has at most `leaf` pieces.
FloatTree build_by_space(const Mesh& mesh, const BuildLimits& limits, const SpaceRules& rules);

}  // namespace cbvh::golden
