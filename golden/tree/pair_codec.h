// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "golden/build/float_tree.h"
#include "golden/quantize/quantize.h"
#include "golden/tree/compressed_tree.h"

namespace cbvh::golden {

/// A quantized box: its cells on some grid, per axis.
template <class Index>
using CellBox = std::array<Cells<Index>, 3>;

/// Both children of a pair as cells on the grid of the node they belong to.
template <class Index>
using PairCells = std::array<CellBox<Index>, 2>;

/// A float box as cells on the grid of its parent (DESIGN section 3, rule 2).
template <class Index>
CellBox<Index> encode_cells(const Box& box, const Context<Index>& parent) {
  return {encode<Index>(box.lower.x, box.upper.x, parent[0].scale),
          encode<Index>(box.lower.y, box.upper.y, parent[1].scale),
          encode<Index>(box.lower.z, box.upper.z, parent[2].scale)};
}

/// Both children of a float pair as cells.
template <class Index>
PairCells<Index> encode_cells(const FloatPair& pair, const Context<Index>& context) {
  return {encode_cells(pair.child[0], context), encode_cells(pair.child[1], context)};
}

/// The context of a child: its own grids, from its cells on its parent's (rule 4).
template <class Index>
Context<Index> child_context(const CellBox<Index>& cells, const Context<Index>& parent, const GridRules& rules) {
  Context<Index> context;
  for (std::size_t axis = 0; axis < 3; ++axis) context[axis] = own_context(cells[axis], parent[axis].scale, rules);
  return context;
}

/// Cells to codes (rule 5).
template <class Index>
std::array<AxisCodes, 3> encode_codes(const CellBox<Index>& cells, const Context<Index>& parent, Code code, int bits) {
  std::array<AxisCodes, 3> codes;
  for (std::size_t axis = 0; axis < 3; ++axis) codes[axis] = encode_codes(cells[axis], parent[axis].lower, code, bits);
  return codes;
}

/// Codes to cells (rule 5).
template <class Index>
CellBox<Index> decode_codes(const std::array<AxisCodes, 3>& codes, const Context<Index>& parent, Code code, int bits) {
  CellBox<Index> cells;
  for (std::size_t axis = 0; axis < 3; ++axis) cells[axis] = decode_codes(codes[axis], parent[axis].lower, code, bits);
  return cells;
}

/// A pair's codes to cells.
template <class Index>
PairCells<Index> decode_codes(const CompressedPair& pair, const Context<Index>& context, Code code, int bits) {
  return {decode_codes(pair.child[0].codes, context, code, bits),
          decode_codes(pair.child[1].codes, context, code, bits)};
}

/// The stored form of a float pair whose cells are known.
template <class Index>
CompressedPair compress_pair(const FloatPair& pair, const PairCells<Index>& cells, const Context<Index>& context,
                             Code code, int bits) {
  return {{{encode_codes(cells[0], context, code, bits), pair.leaf[0], pair.pointer[0]},
           {encode_codes(cells[1], context, code, bits), pair.leaf[1], pair.pointer[1]}}};
}

/// Whether 64-bit indices hold every cell of a scene under these rules; Wide ones always do.
inline bool fits_64_bits(const Box& scene, const GridRules& rules) {
  return rules.min_scale >= exactness_limit(largest_magnitude(scene));
}

}  // namespace cbvh::golden
