// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "golden/build/build_limits.h"
#include "golden/build/builder.h"
#include "golden/build/node_tree.h"

namespace cbvh::golden {

/// The full SAH sweep that paper 002 compares with (its Table 1; its reference 22): a node's triangles are sorted by
/// centroid on each axis, and split before the one where the SAH is least, of equals at the lowest axis, then position.
/// Sorted once and kept sorted, O(n log n), or with `sort=node` in every node anew, O(n log^2 n). Leaves, nodes without
/// area and nodes that would not fit the levels left are treated as in binned.h.
BuilderKind sweep_builder();

enum class SweepSort { once, in_nodes };

/// The same tree over boxes, whichever way they are sorted; its references are their indices.
NodeTree sweep_tree(const std::vector<Box>& boxes, const BuildLimits& limits, SweepSort sort = SweepSort::once);

}  // namespace cbvh::golden
