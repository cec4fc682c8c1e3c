// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/tree/sah.h"

#include "golden/tree/decode.h"

namespace cbvh::golden {
namespace {

double primitives_of(const std::vector<std::uint32_t>& ids, std::size_t first) {
  std::size_t last = first;
  while ((ids[last] & kLastOfLeaf) == 0) ++last;
  return static_cast<double>(last - first + 1);
}

/// child_at(pair, c) gives {box, leaf, pointer}.
template <class ChildAt>
double sum(std::size_t pairs, const Box& scene, const std::vector<std::uint32_t>& ids, const SahCosts& costs,
           ChildAt child_at) {
  if (pairs == 0) return costs.intersection * static_cast<double>(ids.size());
  const double scene_area = half_area(scene);
  double total = costs.traversal;
  for (std::size_t pair = 0; pair < pairs; ++pair) {
    for (std::size_t c = 0; c < 2; ++c) {
      const auto [box, leaf, pointer] = child_at(pair, c);
      const double cost = leaf ? costs.intersection * primitives_of(ids, pointer) : costs.traversal;
      total += cost * (scene_area > 0 ? half_area(box) / scene_area : 1.0);
    }
  }
  return total;
}

struct SahChild {
  Box box;
  bool leaf;
  std::uint32_t pointer;
};

}  // namespace

double sah(const FloatTree& tree, const SahCosts& costs) {
  return sum(tree.pairs.size(), tree.scene, tree.primitive_ids, costs, [&](std::size_t pair, std::size_t c) {
    const FloatPair& p = tree.pairs[pair];
    return SahChild{p.child[c], p.leaf[c], p.pointer[c]};
  });
}

double sah(const CompressedTree& tree, const SahCosts& costs) {
  const std::vector<std::array<Box, 2>> boxes = decode_boxes(tree);
  return sum(tree.pairs.size(), tree.scene, tree.primitive_ids, costs, [&](std::size_t pair, std::size_t c) {
    const CompressedChild& child = tree.pairs[pair].child[c];
    return SahChild{boxes[pair][c], child.leaf, child.pointer};
  });
}

}  // namespace cbvh::golden
