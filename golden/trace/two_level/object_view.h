// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "golden/build/two_level/object_tree.h"

namespace cbvh::golden {

/// An object's tree, float or compressed, as the traversal sees it.
class ObjectTreeView {
 public:
  explicit ObjectTreeView(const ObjectTree& tree) : tree_(&tree) {}

  using Node = ObjectNode;  ///< a pair
  struct Opened {
    std::array<Box, 2> box;
    std::array<bool, 2> leaf;
    std::array<std::uint32_t, 2> pointer;
    std::array<ObjectNode, 2> node;
  };

  const std::vector<std::uint32_t>& primitive_ids() const { return tree_->primitive_ids(); }

  Opened open(const Node& pair) const {
    const auto [a, b] = tree_->children(pair);
    return {{a.box, b.box},
            {a.node.kind != ObjectNode::Kind::pair, b.node.kind != ObjectNode::Kind::pair},
            {a.node.index, b.node.index},
            {a.node, b.node}};
  }
  const void* first_of(const Opened&, std::size_t) const { return tree_; }  // unknown here
  static constexpr std::size_t kPairBytes = sizeof(ObjectTree);
  static const Node& child(const Node&, const Opened& opened, std::size_t c) { return opened.node[c]; }

 private:
  const ObjectTree* tree_;
};

}  // namespace cbvh::golden
