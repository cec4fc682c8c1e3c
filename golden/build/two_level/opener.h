// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "golden/build/two_level/reference_tree.h"

namespace cbvh::golden {

/// Replaces a reference by references to its children (Benthin et al., sections 5.3 and 5.4): the node's pair is read
/// (and decoded, if it is compressed), the children's boxes are transformed on the fly.
class Opener {
 public:
  /// `width`: a node has up to that many children; binary trees are seen as wider ones by opening the child of the
  /// largest area again. `leaves`: leaves can be opened too, into their triangles.
  Opener(const InstancedTrees& trees, std::uint32_t width, bool leaves);

  bool can_open(const BuildReference& reference) const {
    return reference.to.node.kind == ObjectNode::Kind::pair ||
           (leaves_ && reference.to.node.kind == ObjectNode::Kind::leaf);
  }

  /// The children of a reference that can be opened, left to right for a width of 2. At most `most`, at least 2, and
  /// none if its leaf has more. Valid until the next call with the same scratch.
  void open(const BuildReference& reference, std::size_t most, std::vector<BuildReference>& children) const;

 private:
  void open_pair(const BuildReference& reference, std::size_t most, std::vector<BuildReference>& children) const;
  void open_leaf(const BuildReference& reference, std::size_t most, std::vector<BuildReference>& children) const;
  WideBox triangle_bounds(const Instance& instance, std::uint32_t triangle) const;

  const InstancedTrees& trees_;
  std::uint32_t width_;
  bool leaves_;
};

}  // namespace cbvh::golden
