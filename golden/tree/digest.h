// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "golden/tree/compressed_tree.h"

namespace cbvh::golden {

/// FNV-1a-64 over every pair in emission order, as DESIGN 3.2 fixes it. Always over modulo codes, so trees of either
/// code compare: a relative tree is decoded first. A tree without pairs has the hash of nothing, cbf29ce484222325.
std::uint64_t digest(const CompressedTree& tree);

}  // namespace cbvh::golden
