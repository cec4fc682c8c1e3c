// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "golden/build/float_tree.h"

namespace cbvh::golden {

/// What is wrong with a builder's tree, pair by pair; nothing if it is as every builder promises: emission order (every
/// pair reached once, children before parents, leaves side by side), every triangle in a leaf and none twice in one,
/// inner boxes exactly around their children, and the boxes of leaves exactly around their triangles; if several leaves
/// share triangles, the boxes of leaves lie within that (golden/tree/coverage.h says whether they cover them). At most
/// `most` findings.
std::vector<std::string> check_tree(const FloatTree& tree, const Mesh& mesh, std::size_t most = 20);

}  // namespace cbvh::golden
