// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "golden/build/float_tree.h"
#include "rtl_model/datapath/payloads.h"
#include "vectors/random.h"

/// Float trees as the stream of pairs that a builder emits: depth first, bottom up.
namespace cbvh::vectors {

struct TreeNode {
  golden::Box box;
  bool leaf;
  std::uint32_t pointer;
};

/// Emits pairs in order; every inner node's box is the union of its children's.
class TreeEmitter {
 public:
  TreeNode leaf(const golden::Box& box) { return {box, true, primitives_++}; }
  TreeNode pair(const TreeNode& left, const TreeNode& right);
  /// Gives all pairs the registers, raised to the exactness limit of the boxes, and marks the last pair as the root.
  std::vector<rtl::StreamJob> finish(const rtl::SceneRegisters& registers);

 private:
  std::vector<rtl::StreamJob> jobs_;
  std::uint32_t primitives_ = 0;
};

/// How the nodes hang together.
enum class TreeShape : std::uint8_t {
  single_pair,
  left_spine,     ///< every right child is a leaf
  right_spine,    ///< every left child is a leaf
  pending_spine,  ///< every left child is a pair of leaves: as many open subtrees as levels
  balanced,
  random
};

/// Where the leaves lie.
enum class TreePlaces : std::uint8_t {
  halved,     ///< each node has about a half of its parent's box, so that depth narrows boxes
  scattered,  ///< anywhere in the scene
  identical,  ///< all leaves are the same box
  planar,     ///< one axis is a plane
  points,     ///< leaves without extent
  full_span,  ///< boxes on the edges of a power-of-two grid, so that sizes are 2^N cells
  negative    ///< a small object far below zero
};

/// A tree of up to `levels` levels of pairs (at most 31), without registers.
TreeEmitter random_tree(TreeShape shape, TreePlaces places, int levels, Random& random);

/// The stream of a tree that golden built.
std::vector<rtl::StreamJob> stream_of(const golden::FloatTree& tree, const rtl::SceneRegisters& registers);

}  // namespace cbvh::vectors
