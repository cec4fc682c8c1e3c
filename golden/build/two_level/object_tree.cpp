// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/build/two_level/object_tree.h"

#include <glm/common.hpp>
#include <limits>

#include "golden/input_error.h"
#include "golden/tree/decode.h"

namespace cbvh::golden {
namespace {

using Kind = ObjectNode::Kind;

template <class Child>
ObjectNode node_of(const Child& child) {
  return {child.leaf ? Kind::leaf : Kind::pair, child.pointer, {}};
}

/// The root of a tree without pairs is its only leaf.
template <class Tree>
ObjectNode root_node(const Tree& tree) {
  if (tree.pairs.empty()) return {Kind::leaf, 0, {}};
  return {Kind::pair, static_cast<std::uint32_t>(tree.pairs.size() - 1), {}};
}

class FloatObject : public ObjectTree {
 public:
  explicit FloatObject(const FloatTree& of) : tree(of) {}

  BoxedNode root() const override { return {root_node(tree), tree.scene}; }
  std::array<BoxedNode, 2> children(const ObjectNode& node) const override {
    const FloatPair& pair = tree.pairs[node.index];
    return {child(pair, 0), child(pair, 1)};
  }
  const std::vector<std::uint32_t>& primitive_ids() const override { return tree.primitive_ids; }
  std::uint32_t primitives() const override { return tree.primitives; }
  std::size_t pairs() const override { return tree.pairs.size(); }

 private:
  static BoxedNode child(const FloatPair& pair, int c) {
    return {{pair.leaf[c] ? Kind::leaf : Kind::pair, pair.pointer[c], {}}, pair.child[c]};
  }

  const FloatTree& tree;
};

template <class To, class From>
Context<To> converted(const Context<From>& context) {
  Context<To> result;
  for (std::size_t axis = 0; axis < 3; ++axis)
    result[axis] = {context[axis].scale, static_cast<To>(context[axis].lower)};
  return result;
}

class CompressedObject : public ObjectTree {
 public:
  explicit CompressedObject(const CompressedTree& of) : tree(of) {}

  BoxedNode root() const override {
    BoxedNode root{root_node(tree), tree.scene};
    if (root.node.kind == Kind::pair) root.node.context = converted<std::int32_t>(root_of<std::int64_t>(tree));
    return root;
  }
  std::array<BoxedNode, 2> children(const ObjectNode& node) const override {
    const CompressedPair& pair = tree.pairs[node.index];
    const auto context = converted<std::int64_t>(node.context);
    const PairCells<std::int64_t> cells = decode_codes(pair, context, tree.code, tree.rules.bits);
    return {child(pair.child[0], cells[0], context), child(pair.child[1], cells[1], context)};
  }
  const std::vector<std::uint32_t>& primitive_ids() const override { return tree.primitive_ids; }
  std::uint32_t primitives() const override { return tree.primitives; }
  std::size_t pairs() const override { return tree.pairs.size(); }

 private:
  BoxedNode child(const CompressedChild& child, const CellBox<std::int64_t>& cells,
                  const Context<std::int64_t>& parent) const {
    BoxedNode result{node_of(child), to_box(cells, parent)};
    if (!child.leaf) result.node.context = converted<std::int32_t>(child_context(cells, parent, tree.rules));
    // An edge of 2^128 is infinite (rule 3); nothing inside lies beyond the largest float.
    constexpr float kMax = std::numeric_limits<float>::max();
    result.box = {glm::max(result.box.lower, -kMax), glm::min(result.box.upper, kMax)};
    return result;
  }

  const CompressedTree& tree;
};

}  // namespace

std::unique_ptr<ObjectTree> object_tree(const FloatTree& tree) { return std::make_unique<FloatObject>(tree); }

std::unique_ptr<ObjectTree> object_tree(const CompressedTree& tree, const std::string& place) {
  if (!fits_64_bits(tree.scene, tree.rules))
    throw InputError(place, fmt::format("minimum scale: found {}, wanted one at the exactness limit of the scene's "
                                        "coordinates or above",
                                        tree.rules.min_scale));
  return std::make_unique<CompressedObject>(tree);
}

std::uint32_t leaf_size(const std::vector<std::uint32_t>& primitive_ids, std::uint32_t first) {
  std::uint32_t last = first;
  while ((primitive_ids[last] & kLastOfLeaf) == 0) ++last;
  return last - first + 1;
}

}  // namespace cbvh::golden
