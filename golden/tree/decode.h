// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "golden/tree/pair_codec.h"

namespace cbvh::golden {

/// The root context of a tree in the index type asked for; std::int64_t only where fits_64_bits.
template <class Index>
Context<Index> root_of(const CompressedTree& tree) {
  Context<Index> root;
  for (std::size_t axis = 0; axis < 3; ++axis)
    root[axis] = {tree.root[axis].scale, static_cast<Index>(tree.root[axis].lower)};
  return root;
}

/// Calls visit(index, context, cells) for every pair, depth first, parents before children: the pair's own grid and its
/// two children as cells on it. The tree must be valid (golden/tree/validate.h).
template <class Index, class Visit>
void visit_pairs(const CompressedTree& tree, Visit&& visit) {
  struct Open {
    std::uint32_t pair;
    Context<Index> context;
  };
  std::vector<Open> stack;
  if (!tree.pairs.empty()) stack.push_back({static_cast<std::uint32_t>(tree.pairs.size() - 1), root_of<Index>(tree)});
  while (!stack.empty()) {
    const Open open = stack.back();
    stack.pop_back();
    const CompressedPair& pair = tree.pairs[open.pair];
    const PairCells<Index> cells = decode_codes(pair, open.context, tree.code, tree.rules.bits);
    for (const std::size_t c : {std::size_t{1}, std::size_t{0}}) {
      if (!pair.child[c].leaf)
        stack.push_back({pair.child[c].pointer, child_context(cells[c], open.context, tree.rules)});
    }
    visit(open.pair, open.context, cells);
  }
}

/// The two child boxes of every pair, by pair index, in binary32. Exact at or above the exactness limit; rounded
/// outwards below it.
std::vector<std::array<Box, 2>> decode_boxes(const CompressedTree& tree);

/// The same tree in the other code; equal boxes, equal pointers.
CompressedTree to_code(const CompressedTree& tree, Code code);

/// One quantized box as floats, rounded outwards where no float is equal (equation 3 on zero-aligned grids).
template <class Index>
Box to_box(const CellBox<Index>& cells, const Context<Index>& parent) {
  Box box{};
  for (int axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    box.lower[axis] = edge_down(cells[a].lower, parent[a].scale);
    box.upper[axis] = edge_up(cells[a].upper, parent[a].scale);
  }
  return box;
}

}  // namespace cbvh::golden
