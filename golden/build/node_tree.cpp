// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/build/node_tree.h"

#include <algorithm>

namespace cbvh::golden {
namespace {

/// What a pair says of one of its children.
struct Emitted {
  Box box;
  bool leaf;
  std::uint32_t pointer;
};

/// Post-order over the nodes with a stack of our own: a node is opened, its children are emitted, then its pair.
class Emitter {
 public:
  Emitter(const NodeTree& from, FloatTree& to) : tree(from), result(to) {}

  /// Returns the root's box.
  Box run() {
    open.push_back({0, false});
    while (!open.empty()) {
      const Visit visit = open.back();
      open.pop_back();
      const NodeTree::Node& node = tree.nodes[visit.node];
      if (node.count > 0) {
        emit_leaf(node);
      } else if (visit.children_done) {
        emit_pair();
      } else {
        open.push_back({visit.node, true});
        open.push_back({node.first + 1, false});
        open.push_back({node.first, false});
      }
    }
    return done.back().box;
  }

 private:
  struct Visit {
    std::uint32_t node;
    bool children_done;
  };

  void emit_leaf(const NodeTree::Node& node) {
    const auto first = static_cast<std::uint32_t>(result.primitive_ids.size());
    const auto from = tree.references.begin() + node.first;
    result.primitive_ids.insert(result.primitive_ids.end(), from, from + node.count);
    result.primitive_ids.back() |= kLastOfLeaf;
    ++result.leaves;
    done.push_back({node.box, true, first});
  }

  void emit_pair() {
    const Emitted right = done.back();
    done.pop_back();
    const Emitted left = done.back();
    result.pairs.push_back({{left.box, right.box}, {left.leaf, right.leaf}, {left.pointer, right.pointer}});
    done.back() = {unite(left.box, right.box), false, static_cast<std::uint32_t>(result.pairs.size() - 1)};
  }

  const NodeTree& tree;
  FloatTree& result;
  std::vector<Visit> open;
  std::vector<Emitted> done;
};

}  // namespace

FloatTree emit(const NodeTree& tree, std::size_t primitives, const std::string& place) {
  check_counts(place, tree.references.size(), tree.nodes.size() / 2);
  FloatTree result;
  result.primitives = static_cast<std::uint32_t>(primitives);
  result.primitive_ids.reserve(tree.references.size());
  result.pairs.reserve(tree.nodes.size() / 2);
  result.scene = Emitter(tree, result).run();
  result.largest_magnitude = largest_magnitude(result.scene);
  return result;
}

int depth(const FloatTree& tree) {
  std::vector<int> below(tree.pairs.size());
  for (std::size_t pair = 0; pair < tree.pairs.size(); ++pair) {
    for (int c = 0; c < 2; ++c) {
      if (!tree.pairs[pair].leaf[c]) below[pair] = std::max(below[pair], below[tree.pairs[pair].pointer[c]]);
    }
    ++below[pair];
  }
  return below.empty() ? 0 : below.back();
}

}  // namespace cbvh::golden
