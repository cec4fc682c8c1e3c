// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "golden/build/node_tree.h"
#include "golden/build/wide_box.h"
#include "golden/scene/mesh.h"
#include "golden/threads/team.h"

namespace cbvh::golden {

/// A node to build: the references [first, first + count) of one of two buffers. Its descendants' nodes start at
/// `below`: 2 count - 2 of them at most, so that threads can build subtrees in one array without asking each other
/// (paper 002, section 5).
struct Subtree {
  std::uint32_t first = 0;
  std::uint32_t count = 0;
  std::uint32_t node = 0;
  std::uint32_t below = 1;
  int levels = 0;     ///< of inner nodes that it may have
  bool side = false;  ///< the buffer
  WideBox box;
};

/// The references of a mesh in two buffers, between which they move back and forth as nodes are divided, and the tree
/// that results. References keep their order within a half, so that results do not depend on who moved them.
class SubtreeArrays {
 public:
  /// For `count` references, which are still to be written: members write their shares.
  explicit SubtreeArrays(std::uint32_t count);

  std::uint32_t count() const { return count_; }
  Reference* buffer(bool side) { return buffers_[side ? 1 : 0].get(); }
  std::span<const Reference> references(const Subtree& node) { return {buffer(node.side) + node.first, node.count}; }
  const NodeTree& tree() const { return tree_; }

  /// The box of the centroids of a node's references.
  WideBox centroids(const Subtree& node);

  /// Makes an inner node whose left half has `left` references, already in the other buffer; returns its children.
  std::array<Subtree, 2> split(const Subtree& node, std::uint32_t left, const std::array<WideBox, 2>& boxes) {
    tree_.nodes[node.node] = {{}, node.below, 0};
    return halves(node, left, boxes);
  }

  /// The children that `split` returns, without making the node.
  static std::array<Subtree, 2> halves(const Subtree& node, std::uint32_t left, const std::array<WideBox, 2>& boxes) {
    return {Subtree{node.first, left, node.below, node.below + 2, node.levels - 1, !node.side, boxes[0]},
            Subtree{node.first + left, node.count - left, node.below + 1, node.below + 2 * left, node.levels - 1,
                    !node.side, boxes[1]}};
  }

  /// Moves the `left` references for which is_left(index, reference) holds to the front of the other buffer, the
  /// others behind them.
  template <class IsLeft>
  void move(const Subtree& node, std::uint32_t left, const IsLeft& is_left) {
    const Reference* const from = buffer(node.side) + node.first;
    Reference* const to = buffer(!node.side) + node.first;
    std::array<std::uint32_t, 2> next{0, left};
    for (std::uint32_t i = 0; i < node.count; ++i) to[next[is_left(i, from[i]) ? 0 : 1]++] = from[i];
  }

  /// Moves them, and makes the node.
  template <class IsLeft>
  std::array<Subtree, 2> divide(const Subtree& node, std::uint32_t left, const IsLeft& is_left) {
    move(node, left, is_left);
    const Reference* const to = buffer(!node.side) + node.first;
    std::array<WideBox, 2> boxes;
    for (std::uint32_t i = 0; i < left; ++i) boxes[0].enclose(to[i].box());
    for (std::uint32_t i = left; i < node.count; ++i) boxes[1].enclose(to[i].box());
    return split(node, left, boxes);
  }

  /// Divides at the object median along the longest axis of the centroids; at least two references.
  std::array<Subtree, 2> divide_at_median(const Subtree& node);

  void make_leaf(const Subtree& node);

 private:
  struct Free {
    void operator()(Reference* array) const;
    std::size_t count;
  };
  /// Not written by whoever takes it: threads that fill it also pay for its pages.
  static std::unique_ptr<Reference[], Free> unwritten(std::size_t count);

  std::uint32_t count_;
  std::array<std::unique_ptr<Reference[], Free>, 2> buffers_;
  NodeTree tree_;
};

/// Writes the member's share of a mesh's references into buffer 0; returns their box and their centroids'.
std::array<WideBox, 2> write_references(const Mesh& mesh, const TeamMember& member, SubtreeArrays& arrays);

/// Builds subtrees on so many threads, the largest first.
void build_subtrees(std::vector<Subtree> subtrees, int threads, const std::function<void(const Subtree&)>& build);

}  // namespace cbvh::golden
