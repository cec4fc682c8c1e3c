// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "golden/build/builder.h"

namespace cbvh::golden {

/// The spatial median builder that paper 002 calls BIH-style: nodes halve the box of the centroids along its longest
/// axis, again and again, whatever lies in it; where a half is empty the box shrinks to what it holds. The highest
/// nodes come from a grid (top_grid.h), so that threads can share the work. Leaves, and nodes that cannot be halved or
/// would not fit the levels left, as in binned.h.
BuilderKind median_builder();

}  // namespace cbvh::golden
