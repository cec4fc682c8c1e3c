// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "golden/build/float_tree.h"
#include "golden/build/unwritten.h"

namespace cbvh::golden {

/// A binary tree as top-down builders leave it: nodes in any order, so that threads can fill parts of an array that was
/// taken once. A subtree of n leaves needs 2n - 1 nodes.
struct NodeTree {
  struct Node {
    Box box;  ///< of a leaf; what inner nodes enclose follows from the leaves
    std::uint32_t
        first;  ///< of a leaf: its first entry in `references`; else the index of child 0, child 1 is the next
    std::uint32_t count;  ///< of a leaf: its references, at least 1; 0 of an inner node
  };
  std::vector<Node, Unwritten<Node>> nodes;  ///< the root is nodes[0]; places that no node points to are left out
  std::vector<std::uint32_t, Unwritten<std::uint32_t>> references;  ///< primitive IDs; a leaf's lie side by side
};

/// The tree in emission order, with boxes of inner nodes tight around their children's. `primitives` of the scene.
/// Throws InputError named `place` when the counts do not fit a node pair's pointers. However deep the tree, the depth
/// of calls is bounded. Several threads emit parts of the tree; the result is the same.
FloatTree emit(const NodeTree& tree, std::size_t primitives, const std::string& place, int threads = 1);

/// Levels of inner nodes on the longest way from the root to a leaf; 0 for a tree that is one leaf.
int depth(const FloatTree& tree);

}  // namespace cbvh::golden
