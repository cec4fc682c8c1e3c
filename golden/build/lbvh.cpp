// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/build/lbvh.h"

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
  constexpr std::uint32_t kDigits = 1024;
  const auto digit = [](const CodedPrimitive& p, std::size_t pass) { return p.code >> (10 * pass) & (kDigits - 1); };
  std::array<std::array<std::uint32_t, kDigits>, 3> next{};
  for (const CodedPrimitive& p : from) {
    for (std::size_t pass = 0; pass < next.size(); ++pass) ++next[pass][digit(p, pass)];
  }
  std::vector<CodedPrimitive> to(from.size());
  for (std::size_t pass = 0; pass < next.size(); ++pass) {
    std::uint32_t sum = 0;
    for (std::uint32_t& n : next[pass]) sum += std::exchange(n, sum);
    for (const CodedPrimitive& p : from) to[next[pass][digit(p, pass)]++] = p;
    from.swap(to);
  }
  return from;
}

struct Node {
  Box box;
  bool leaf;
  std::uint32_t pointer;
};

/// The hierarchy over leaves that come in the order of their codes. Between two neighbours the highest differing bit
/// says where they part: a subtree is complete when a higher bit than the one that parts its children differs. Open
/// left subtrees wait on a stack, from the top down parted by ever higher bits: at most 30, the length of a code.
class Hierarchy {
 public:
  explicit Hierarchy(std::vector<FloatPair>& to) : pairs_(to) {}

  /// `parting`: the highest bit in which the next leaf's code differs; greater than any code after the last leaf. Pairs
  /// come as they must: left subtree, right subtree, the pair.
  void add(Node node, std::uint32_t parting) {
    for (; open_ > 0 && waiting_[open_ - 1].parting < parting; --open_) {
      const Node& left = waiting_[open_ - 1].node;
      pairs_.push_back({{left.box, node.box}, {left.leaf, node.leaf}, {left.pointer, node.pointer}});
      node = {unite(left.box, node.box), false, static_cast<std::uint32_t>(pairs_.size() - 1)};
    }
    waiting_[open_++] = {node, parting};
  }

 private:
  struct Waiting {
    Node node;
    std::uint32_t parting;
  };
  std::vector<FloatPair>& pairs_;
  std::array<Waiting, 31> waiting_;
  std::size_t open_ = 0;
};

/// Primitive IDs, leaves and pairs of primitives in order of their codes; box_of(i) is the box of the i-th. A run of
/// equal codes is a leaf.
template <class BoxOf>
void emit_hierarchy(std::span<const CodedPrimitive> sorted, const BoxOf& box_of, FloatTree& tree) {
  tree.primitive_ids.resize(sorted.size());
  tree.pairs.reserve(sorted.size() - 1);
  Hierarchy hierarchy(tree.pairs);
  for (std::size_t i = 0; i < sorted.size();) {
    const std::size_t first = i;
    const std::uint32_t code = sorted[first].code;
    Box box = box_of(first);
    tree.primitive_ids[first] = sorted[first].id;
    for (++i; i < sorted.size() && sorted[i].code == code; ++i) {
      box = unite(box, box_of(i));
      tree.primitive_ids[i] = sorted[i].id;
    }
    tree.primitive_ids[i - 1] |= kLastOfLeaf;
    const std::uint32_t parting = i < sorted.size() ? std::bit_floor(sorted[i].code ^ code) : ~0U;
    hierarchy.add({box, true, static_cast<std::uint32_t>(first)}, parting);
  }
  tree.leaves = static_cast<std::uint32_t>(tree.pairs.size() + 1);
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
