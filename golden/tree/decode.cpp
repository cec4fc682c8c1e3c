// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/tree/decode.h"

namespace cbvh::golden {
namespace {

template <class Index>
void decode_into(const CompressedTree& tree, std::vector<std::array<Box, 2>>& boxes) {
  visit_pairs<Index>(tree, [&](std::uint32_t pair, const Context<Index>& context, const PairCells<Index>& cells) {
    boxes[pair] = {to_box(cells[0], context), to_box(cells[1], context)};
  });
}

template <class Index>
void recode_into(const CompressedTree& tree, CompressedTree& recoded) {
  visit_pairs<Index>(tree, [&](std::uint32_t pair, const Context<Index>& context, const PairCells<Index>& cells) {
    for (std::size_t c = 0; c < 2; ++c) {
      recoded.pairs[pair].child[c].codes = encode_codes(cells[c], context, recoded.code, recoded.rules.bits);
    }
  });
}

}  // namespace

std::vector<std::array<Box, 2>> decode_boxes(const CompressedTree& tree) {
  std::vector<std::array<Box, 2>> boxes(tree.pairs.size());
  if (fits_64_bits(tree.scene, tree.rules)) {
    decode_into<std::int64_t>(tree, boxes);
  } else {
    decode_into<Wide>(tree, boxes);
  }
  return boxes;
}

CompressedTree to_code(const CompressedTree& tree, Code code) {
  CompressedTree recoded = tree;
  recoded.code = code;
  if (code == tree.code) return recoded;
  if (fits_64_bits(tree.scene, tree.rules)) {
    recode_into<std::int64_t>(tree, recoded);
  } else {
    recode_into<Wide>(tree, recoded);
  }
  return recoded;
}

}  // namespace cbvh::golden
