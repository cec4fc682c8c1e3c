// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <bit>
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
    Opened opened{{},
                  {pair.child[0].leaf, pair.child[1].leaf},
                  {pair.child[0].pointer, pair.child[1].pointer},
                  {cells_of(pair.child[0], node.context), cells_of(pair.child[1], node.context)}};
    const double x = power_of_two(node.context[0].scale);
    const double y = power_of_two(node.context[1].scale);
    const double z = power_of_two(node.context[2].scale);
    for (std::size_t c = 0; c < 2; ++c) {
      const CellBox<Index>& cells = opened.cells[c];
      opened.box[c] = {{edge(cells[0].lower, x), edge(cells[1].lower, y), edge(cells[2].lower, z)},
                       {edge(cells[0].upper, x), edge(cells[1].upper, y), edge(cells[2].upper, z)}};
    }
    return opened;
  }

  /// What a ray needs first of a child.
  const void* first_of(const Opened& opened, std::size_t c) const {
    const std::uint32_t pointer = opened.pointer[c];
    return opened.leaf[c] ? static_cast<const void*>(&tree_->primitive_ids[pointer]) : &tree_->pairs[pointer];
  }
  static constexpr std::size_t kPairBytes = sizeof(CompressedPair);

  /// child_context, without its loop: the least s with cells <= 2^(N - s) is known from the cells' bits.
  Node child(const Node& node, const Opened& opened, std::size_t c) const {
    Node child{opened.pointer[c], {}};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const Cells<Index>& cells = opened.cells[c][axis];
      const auto spanned = static_cast<std::uint64_t>(cells.upper - cells.lower - exclusive_);
      const int finer = std::min(tree_->rules.bits - static_cast<int>(std::bit_width(spanned)),
                                 node.context[axis].scale - tree_->rules.min_scale);
      child.context[axis] = {node.context[axis].scale - finer,
                             cells.lower * (Index{1} << static_cast<unsigned>(finer))};
    }
    return child;
  }

 private:
  /// decode_codes, without a branch: a difference of codes of which 0 stands for 2^N is one more than the rest of it
  /// - 1.
  CellBox<Index> cells_of(const CompressedChild& child, const Context<Index>& parent) const {
    const auto cells = [&](std::size_t axis) {
      const Index lower = parent[axis].lower;
      const Index base = lower & base_mask_;
      const AxisCodes codes = child.codes[axis];
      return Cells<Index>{lower + ((codes.lower - base) & code_mask_),
                          lower + ((codes.upper - base - 1) & code_mask_) + 1};
    };
    return {cells(0), cells(1), cells(2)};
  }

  /// At or above the exactness limit a multiple of the cell is a float, or +-2^128, which becomes +-infinity.
  static float edge(Index index, double cell) { return static_cast<float>(static_cast<double>(index) * cell); }

  const CompressedTree* tree_;
  Index code_mask_;  ///< of N bits
  Index base_mask_;  ///< of what codes are relative to: nothing, or with modulo codes the parent's lower index
  Index exclusive_;  ///< 1 if a node may span 2^N cells, 0 if one less
};

}  // namespace cbvh::golden
