// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "golden/build/float_tree.h"
#include "golden/tree/compressed_tree.h"

namespace cbvh::golden {

/// A node inside an object's tree, as a top level can refer to it.
struct ObjectNode {
  enum class Kind : std::uint8_t {
    pair,      ///< an inner node: its children are a pair of the tree
    leaf,      ///< a whole leaf
    primitive  ///< one triangle of a leaf
  };
  Kind kind;
  std::uint32_t index;  ///< of the pair, of the leaf's first primitive-ID entry, or the triangle's
  Context<std::int32_t>
      context;  ///< of a pair of a compressed tree: its own grid, where a traversal starts; else zeros
};

/// An object-space node with the box that its parent holds of it: the exact one of a float tree, the decoded one of a
/// compressed tree.
struct BoxedNode {
  ObjectNode node;
  Box box;
};

/// An object's tree, float or compressed, as a top level looks into it. Stays valid as long as what it was made from.
class ObjectTree {
 public:
  virtual ~ObjectTree() = default;

  virtual BoxedNode root() const = 0;
  /// Of a node that is a pair.
  virtual std::array<BoxedNode, 2> children(const ObjectNode& pair) const = 0;
  virtual const std::vector<std::uint32_t>& primitive_ids() const = 0;
  virtual std::uint32_t primitives() const = 0;
  virtual std::size_t pairs() const = 0;
};

std::unique_ptr<ObjectTree> object_tree(const FloatTree& tree);

/// Opening decodes a pair on the grid that its node carries. Throws InputError named `place` below the exactness limit,
/// where decoded edges are no floats.
std::unique_ptr<ObjectTree> object_tree(const CompressedTree& tree, const std::string& place);

/// The entries of the leaf that starts at entry `first` of an array of primitive IDs.
std::uint32_t leaf_size(const std::vector<std::uint32_t>& primitive_ids, std::uint32_t first);

}  // namespace cbvh::golden
