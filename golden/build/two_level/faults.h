// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "golden/build/two_level/top_level.h"

namespace cbvh::golden {

/// What is wrong with a top level, at most `most` lines; empty if nothing: every triangle of every instance lies below
/// exactly one reference, every reference below exactly one leaf, every leaf's box encloses the triangles of its
/// reference in the world, and every other box is the one around its children.
std::vector<std::string> faults_of(const TopLevel& top, const InstancedTrees& trees, std::size_t most = 100);

}  // namespace cbvh::golden
