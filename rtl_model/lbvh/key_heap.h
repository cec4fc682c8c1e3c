// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace cbvh::rtl {

/// What the heap orders: wires that compare as one number, and the scratchpad slot they speak for.
struct HeapKey {
  static constexpr std::uint64_t kNothing = ~std::uint64_t{0};
  std::uint64_t order = kNothing;
  std::uint32_t slot = 0;
};

/// A pipelined heap that takes a key, or gives its smallest one away, or both, every clock. In hardware every level of
/// the tree is a stage with a memory bank of its own. A node holds the two smallest keys of its subtree, so that the
/// smallest when `first` has gone is `second` or the key that came: known without a look below. Only the new `second`
/// may have to come from below, from the `first` of a child, which for the same reason that level knows in the same
/// clock, though it still works on the operation before. So operations follow each other without a gap, and no path
/// crosses more than two levels. A level reads the nodes of two children and writes one node a clock. Here an operation
/// is carried down at once: from the root nobody can see the difference.
class KeyHeap {
 public:
  /// Room for `capacity` keys, at least 2.
  explicit KeyHeap(std::size_t capacity) : last_node_((capacity + 1) / 2), nodes_(last_node_ + 2) {
    assert(capacity >= 2);
  }

  const HeapKey& first() const { return nodes_[1].first; }

  /// Adds a key to the `held` ones of a heap that was only added to since it was empty: nodes fill level by level, and
  /// the key sinks along the path to the one whose turn it is.
  void insert(HeapKey key, std::size_t held) {
    const std::size_t target = held / 2 + 1;
    for (auto level = static_cast<unsigned>(std::bit_width(target)); level-- > 0;) {
      Node& node = nodes_[target >> level];
      if (key.order < node.first.order) std::swap(key, node.first);
      if (key.order < node.second.order) std::swap(key, node.second);
    }
    assert(key.order == HeapKey::kNothing);
  }

  /// Takes the first key away and adds `key`, which may be nothing. Orders compare with the bits of `inverted`
  /// inverted: what is nothing comes last in any case, its highest bits are set.
  void replace_first(HeapKey key, std::uint64_t inverted) {
    const auto less = [inverted](const HeapKey& a, const HeapKey& b) {
      return (a.order ^ inverted) < (b.order ^ inverted);
    };
    std::size_t place = 1;
    while (true) {
      Node& node = nodes_[place];
      const bool keeps_order = less(node.second, key);
      const HeapKey larger = keeps_order ? key : node.second;
      node.first = keeps_order ? node.second : key;
      node.second = larger;
      if (2 * place > last_node_) return;
      place = 2 * place + less(nodes_[2 * place + 1].first, nodes_[2 * place].first);
      if (!less(nodes_[place].first, larger)) return;
      node.second = nodes_[place].first;
      key = larger;
    }
  }

 private:
  struct Node {
    HeapKey first;
    HeapKey second;
  };

  std::size_t last_node_;
  std::vector<Node> nodes_;  ///< the root is 1, the children of i are 2 i and 2 i + 1; the one behind the last is empty
};

}  // namespace cbvh::rtl
