// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "golden/build/float_tree.h"
#include "golden/tree/compressed_tree.h"

namespace cbvh::golden {

/// What a step costs in the surface area heuristic.
struct SahCosts {
  double traversal = 1;     ///< of an inner node
  double intersection = 1;  ///< of a primitive
};

/// The surface area heuristic: over inner nodes traversal * area, over leaves intersection * primitives * area, each
/// area relative to the scene's float box. Both functions divide by the same area, so their ratio is what quantization
/// costs. A scene box without area gives every node the relative area 1.
double sah(const FloatTree& tree, const SahCosts& costs = {});

/// The same of the decoded boxes of a quantized tree.
double sah(const CompressedTree& tree, const SahCosts& costs = {});

}  // namespace cbvh::golden
