// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "golden/build/float_tree.h"

namespace cbvh::golden {

/// A triangle of which a part lies in none of the boxes of the leaves that hold it.
struct CoverageGap {
  std::uint32_t triangle;
  std::array<double, 3> witness;  ///< a point of that part, rounded
};

/// Whether the boxes of the leaves that hold a triangle cover all of it (paper 001, section 4.1, figure 5 a), exactly:
/// in rational arithmetic, triangles that are segments or points included. Of every `stride`-th triangle, from the
/// first; at most `most` gaps, one a triangle. The tree is valid (check_tree).
std::vector<CoverageGap> coverage_gaps(const FloatTree& tree, const Mesh& mesh, std::uint32_t stride = 1,
                                       std::size_t most = 20);

}  // namespace cbvh::golden
