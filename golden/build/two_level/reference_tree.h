// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "golden/build/node_tree.h"
#include "golden/build/two_level/top_level.h"
#include "golden/build/wide_box.h"

namespace cbvh::golden {

/// What top levels are built from: a BRef (Benthin et al., section 3.2).
struct BuildReference {
  WideBox bounds;            ///< conservative, in the world
  std::uint32_t primitives;  ///< an estimate, at least 1: an opened node's are divided among its children (section 5.3)
  SubtreeReference to;
};

/// One for each instance's whole tree, in their order. Counts of primitives are halved until they fit 31 bits together.
std::vector<BuildReference> whole_instances(const InstancedTrees& trees);

/// The conservative world box of a box inside an instance. As check_scene has seen that everything lies within
/// binary32, what a larger box would add beyond is cut off.
Box bounds_in_world(const Box& box, const Instance& instance);

/// The top level of a tree whose `references` are indices of `from`; one a leaf. Throws InputError as emit does.
TopLevel emit_references(const NodeTree& tree, std::span<const BuildReference> from, const std::string& place);

}  // namespace cbvh::golden
