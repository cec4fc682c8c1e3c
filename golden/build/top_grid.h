// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "golden/build/build_limits.h"
#include "golden/build/subtree_arrays.h"

namespace cbvh::golden {

/// Paper 002, section 5, grid-based splitting: writes a mesh's references, sorts them into the cells of a grid over the
/// centroids, each thread its share, and makes the nodes that halve the grid, `levels` times at most, each time along
/// the then longest axis. What is left to build are the cells' subtrees. The grid depends on the number of triangles
/// (about kTrianglesPerCell each), never on the number of threads.
std::vector<Subtree> split_by_grid(const Mesh& mesh, const BuildLimits& limits, int levels, SubtreeArrays& arrays);

inline constexpr std::uint32_t kTrianglesPerCell = 128;

}  // namespace cbvh::golden
