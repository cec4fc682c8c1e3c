// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "golden/build/builder.h"

namespace cbvh::golden {

/// The full SAH sweep that paper 002 compares with (its Table 1; its reference 22): a node's triangles are sorted by
/// centroid on each axis, and split before the one where the SAH is least, of equals at the lowest axis, then position.
/// Sorted once and kept sorted: O(n log n). Leaves, nodes without area and nodes that would not fit the levels left are
/// treated as in binned.h.
BuilderKind sweep_builder();

}  // namespace cbvh::golden
