// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "golden/build/builder.h"

namespace cbvh::golden {

/// The binned SAH builder of paper 002, section 4: each node's references go into bins of equal width between their
/// centroids, on all three axes, and the node is split between the bins where the SAH is least:
/// C_T area(V) + C_I (area(L) n(L) + area(R) n(R)). A node of at most `leaf` triangles becomes a leaf where that is
/// not less than C_I n area(V). Nodes of no more triangles than bins are swept instead (sweep.h). Nodes without area,
/// whose centroids agree, or whose halves would not fit the levels left, are split at the object median along the
/// longest axis of their centroids. Within a leaf, and where centroids are equal, triangles keep their input order.
BuilderKind binned_builder();

}  // namespace cbvh::golden
