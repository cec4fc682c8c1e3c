// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "golden/tree/decode.h"

namespace cbvh::golden {

/// A compressed tree as the traversal sees it: boxes are decoded on the way down, from the pair's codes and the
/// context of the node it belongs to (DESIGN section 3, rules 4 and 5; the paper's figure 4). They enclose those of the
/// float tree, so the nearest hit is the same (ray.h).
class CompressedTreeView {
 public:
  using Index = std::int64_t;

  /// The tree must be valid (golden/tree/validate.h). Throws InputError when its e_min is below the exactness limit:
  /// such grids have no hardware.
  explicit CompressedTreeView(const CompressedTree& tree);

  /// An inner node: its pair, and its own grid and lower index.
  struct Node {
    std::uint32_t pair;
    Context<Index> context;
  };
  struct Opened {
    std::array<Box, 2> box;
    std::array<bool, 2> leaf;
    std::array<std::uint32_t, 2> pointer;
    PairCells<Index> cells;
  };

  const Box& root_box() const { return tree_->scene; }
  bool is_leaf() const { return tree_->pairs.empty(); }
  Node root() const { return {static_cast<std::uint32_t>(tree_->pairs.size() - 1), root_of<Index>(*tree_)}; }
  const std::vector<std::uint32_t>& primitive_ids() const { return tree_->primitive_ids; }

  Opened open(const Node& node) const {
    const CompressedPair& pair = tree_->pairs[node.pair];
    const PairCells<Index> cells = decode_codes(pair, node.context, tree_->code, tree_->rules.bits);
    return {{to_box(cells[0], node.context), to_box(cells[1], node.context)},
            {pair.child[0].leaf, pair.child[1].leaf},
            {pair.child[0].pointer, pair.child[1].pointer},
            cells};
  }
  Node child(const Node& node, const Opened& opened, std::size_t c) const {
    return {opened.pointer[c], child_context(opened.cells[c], node.context, tree_->rules)};
  }

 private:
  const CompressedTree* tree_;
};

}  // namespace cbvh::golden
