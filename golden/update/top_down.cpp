// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/update/top_down.h"

#include "golden/tree/pair_codec.h"

namespace cbvh::golden {
namespace {

template <class Index>
void compress_below_root(const FloatTree& tree, CompressedTree& compressed) {
  struct Open {
    std::uint32_t pair;
    Context<Index> context;
  };
  std::vector<Open> stack{
      {static_cast<std::uint32_t>(tree.pairs.size() - 1), root_context<Index>(tree.scene, compressed.rules)}};
  while (!stack.empty()) {
    const Open open = stack.back();
    stack.pop_back();
    const FloatPair& pair = tree.pairs[open.pair];
    const PairCells<Index> cells = encode_cells(pair, open.context);
    compressed.pairs[open.pair] = compress_pair(pair, cells, open.context, compressed.code, compressed.rules.bits);
    for (std::size_t c = 0; c < 2; ++c) {
      if (!pair.leaf[c]) stack.push_back({pair.pointer[c], child_context(cells[c], open.context, compressed.rules)});
    }
  }
}

}  // namespace

CompressedTree compress_top_down(const FloatTree& tree, const GridRules& rules, Code code) {
  CompressedTree compressed = blank_compressed_tree(tree, rules, code);
  if (tree.pairs.empty()) return compressed;
  if (fits_64_bits(tree.scene, rules)) {
    compress_below_root<std::int64_t>(tree, compressed);
  } else {
    compress_below_root<Wide>(tree, compressed);
  }
  return compressed;
}

}  // namespace cbvh::golden
