// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/build/lbvh.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
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

/// Leaves, primitive IDs and pairs of primitives in order of their codes; box_of(i) is the box of the i-th.
template <class BoxOf>
void emit_hierarchy(std::span<const CodedPrimitive> sorted, const BoxOf& box_of, FloatTree& tree) {
  std::vector<Leaf> leaves;
  tree.primitive_ids.reserve(sorted.size());
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    const CodedPrimitive& p = sorted[i];
    if (leaves.empty() || leaves.back().code != p.code) {
      if (!leaves.empty()) tree.primitive_ids.back() |= kLastOfLeaf;
      leaves.push_back({p.code, static_cast<std::uint32_t>(tree.primitive_ids.size()), box_of(i)});
    } else {
      leaves.back().box = unite(leaves.back().box, box_of(i));
    }
    tree.primitive_ids.push_back(p.id);
  }
  tree.primitive_ids.back() |= kLastOfLeaf;
  tree.leaves = static_cast<std::uint32_t>(leaves.size());

  tree.pairs.reserve(leaves.size() - 1);
  emit(leaves, 0, leaves.size(), tree.pairs);
}

/// What a tree says of its scene as a whole.
template <class BoxOf>
void measure(std::size_t primitives, const BoxOf& box_of, FloatTree& tree) {
  tree.primitives = static_cast<std::uint32_t>(primitives);
  tree.scene = box_of(0);
  for (std::size_t i = 1; i < primitives; ++i) tree.scene = unite(tree.scene, box_of(i));
  tree.largest_magnitude = largest_magnitude(tree.scene);
}

}  // namespace

FloatTree build_lbvh(const Mesh& mesh) {
  const std::vector<Box> boxes = triangle_boxes(mesh);
  FloatTree tree;
  measure(
      boxes.size(), [&](std::size_t id) { return boxes[id]; }, tree);
  std::vector<CodedPrimitive> sorted(boxes.size());
  for (std::uint32_t id = 0; id < tree.primitives; ++id) sorted[id] = {morton_code(boxes[id], tree.scene), id};
  sorted = sorted_by_code(std::move(sorted));
  emit_hierarchy(
      sorted, [&](std::size_t i) { return boxes[sorted[i].id]; }, tree);
  return tree;
}

BuilderKind lbvh_builder() {
  return {"lbvh",
          "linear BVH: split at the highest differing bit of 30-bit Morton codes; equal codes share a leaf",
          {},
          [](const Mesh& mesh, const OptionValues&) { return build_lbvh(mesh); }};
}

FloatTree build_hierarchy(std::span<const CodedBox> sorted) {
  FloatTree tree;
  const auto box_of = [sorted](std::size_t i) { return sorted[i].box; };
  measure(sorted.size(), box_of, tree);
  std::vector<CodedPrimitive> primitives;
  primitives.reserve(sorted.size());
  for (const CodedBox& item : sorted) primitives.push_back({item.code, item.id});
  emit_hierarchy(primitives, box_of, tree);
  return tree;
}

}  // namespace cbvh::golden
