// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "golden/build/build_limits.h"
#include "golden/build/subtree_arrays.h"

namespace cbvh::golden {

/// Paper 002, section 5, parallel binning: writes a mesh's references and splits the largest nodes as the binned
/// builder would, with all threads at each node. What is left to build are subtrees small enough to be shared out, and
/// nodes that bins do not split. One thread leaves the root.
std::vector<Subtree> split_by_binning(const Mesh& mesh, const BuildLimits& limits, int bins, SubtreeArrays& arrays);

}  // namespace cbvh::golden
