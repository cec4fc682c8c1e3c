// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "golden/build/builder.h"

namespace cbvh::golden {

/// The geometric partitioner (paper 001, section 3): the cheapest pair of boxes on a grid that hold each triangle of a
/// node whole, counted by an auxiliary tree, and the cheapest split by centroids, as the paper's own GP-BVH. The
/// generic one without splitting and without a penalty.
BuilderKind geometric_builder();

/// The generic partitioner (section 4): any of the three oracles, a penalty on overlap (equation 5), triangles split
/// between boxes. C-BVH is oracle=centroid (the trees of `sweep`), GK-BVH oracle=kd (those of `spatial`), G-BVH
/// oracle=all,overlap=1e16. With recursion=K the K cheapest partitions are weighed by the expected cost of subtrees
/// split in the middle (end of section 3.4). A node of more than `leaf` triangles whose best plane or boxes cost more
/// than a leaf, exceed `references` or do not fit the levels left is split by objects.
BuilderKind generic_builder();

}  // namespace cbvh::golden
