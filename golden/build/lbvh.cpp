// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/build/lbvh.h"

#include <algorithm>
#include <array>
#include <bit>
#include <utility>

#include "golden/build/morton.h"

namespace cbvh::golden {
namespace {

struct CodedPrimitive {
  std::uint32_t code;
  std::uint32_t id;
};

/// Stable sort by 30-bit code: three counting passes of ten bits.
std::vector<CodedPrimitive> sorted_by_code(std::vector<CodedPrimitive> from) {
  std::vector<CodedPrimitive> to(from.size());
  for (unsigned shift = 0; shift < 30; shift += 10) {
    std::array<std::uint32_t, 1024> next{};
    const auto digit = [shift](const CodedPrimitive& p) { return (p.code >> shift) & 1023U; };
    for (const CodedPrimitive& p : from) ++next[digit(p)];
    std::uint32_t sum = 0;
    for (std::uint32_t& n : next) sum += std::exchange(n, sum);
    for (const CodedPrimitive& p : from) to[next[digit(p)]++] = p;
    from.swap(to);
  }
  return from;
}

/// A run of primitives with equal codes.
struct Leaf {
  std::uint32_t code;
  std::uint32_t first;  ///< in the primitive-ID array
  Box box;
};

struct Node {
  Box box;
  bool leaf;
  std::uint32_t pointer;
};

/// Emits the pairs of leaves [first, last): left subtree, right subtree, the pair. At most 30 deep, the length of a
/// code.
Node emit(const std::vector<Leaf>& leaves, std::size_t first, std::size_t last, std::vector<FloatPair>& pairs) {
  if (last - first == 1) return {leaves[first].box, true, leaves[first].first};
  const std::uint32_t highest = std::bit_floor(leaves[first].code ^ leaves[last - 1].code);
  const auto begin = leaves.begin();
  const auto middle =
      std::partition_point(begin + static_cast<std::ptrdiff_t>(first), begin + static_cast<std::ptrdiff_t>(last),
                           [highest](const Leaf& leaf) { return (leaf.code & highest) == 0; });
  const auto split = static_cast<std::size_t>(middle - begin);
  const Node left = emit(leaves, first, split, pairs);
  const Node right = emit(leaves, split, last, pairs);
  pairs.push_back({{left.box, right.box}, {left.leaf, right.leaf}, {left.pointer, right.pointer}});
  return {unite(left.box, right.box), false, static_cast<std::uint32_t>(pairs.size() - 1)};
}

}  // namespace

FloatTree build_lbvh(const Mesh& mesh) {
  const std::vector<Box> boxes = triangle_boxes(mesh);
  FloatTree tree;
  tree.primitives = static_cast<std::uint32_t>(boxes.size());
  tree.scene = boxes.front();
  for (const Box& box : boxes) tree.scene = unite(tree.scene, box);
  tree.largest_magnitude = largest_magnitude(tree.scene);

  std::vector<CodedPrimitive> sorted(boxes.size());
  for (std::uint32_t id = 0; id < tree.primitives; ++id) sorted[id] = {morton_code(boxes[id], tree.scene), id};
  sorted = sorted_by_code(std::move(sorted));

  std::vector<Leaf> leaves;
  tree.primitive_ids.reserve(boxes.size());
  for (const CodedPrimitive& p : sorted) {
    if (leaves.empty() || leaves.back().code != p.code) {
      if (!leaves.empty()) tree.primitive_ids.back() |= kLastOfLeaf;
      leaves.push_back({p.code, static_cast<std::uint32_t>(tree.primitive_ids.size()), boxes[p.id]});
    } else {
      leaves.back().box = unite(leaves.back().box, boxes[p.id]);
    }
    tree.primitive_ids.push_back(p.id);
  }
  tree.primitive_ids.back() |= kLastOfLeaf;
  tree.leaves = static_cast<std::uint32_t>(leaves.size());

  tree.pairs.reserve(leaves.size() - 1);
  emit(leaves, 0, leaves.size(), tree.pairs);
  return tree;
}

}  // namespace cbvh::golden
