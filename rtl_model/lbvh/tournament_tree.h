// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <bit>
#include <cassert>
#include <cstdint>
#include <vector>

#include "rtl_model/bits/machine_bits.h"
#include "rtl_model/datapath/merge_compare.h"

namespace cbvh::rtl {

/// A record that takes part in a tournament: what decides, and where the record is kept.
struct MergeKey {
  MergeOrder order;
  std::uint32_t slot = 0;
};

/// The merge tree of [VKJ*15]: a binary tree whose nodes hold two keys each, one comparator and one memory a level. A
/// key taken from a node leaves a request there; a clock later the node's level serves it with the better of the two
/// keys below, and so the request moves down a level a clock and the keys up. A key a clock leaves the root, even if
/// all come from one run. A level serves its requests in order and waits when a run below is dry.
///
/// A merge uses as many levels as its runs need: the runs are the children of the lowest of them. A part of its owner,
/// which ticks it.
template <class Bits>
class TournamentTree {
 public:
  /// For up to `most_leaves` runs, at least 2.
  explicit TournamentTree(std::size_t most_leaves) : nodes_(std::bit_ceil(most_leaves)) {}

  /// Empties the tree for a merge of so many runs. Each level then asks for two keys for each of its nodes.
  void start(std::size_t leaves) {
    level_count_ = leaves <= 2 ? 1 : static_cast<std::size_t>(std::bit_width(leaves - 1));
    for (std::size_t i = 0; i < std::size_t{1} << level_count_; ++i) nodes_[i] = {};
    for (std::size_t i = 0; i < level_count_; ++i) levels_[i] = {std::size_t{2} << i, {}};
    taken_ = false;
  }

  bool can_pop() const { return nodes_[1].count > 0; }
  /// At most once a clock, before tick().
  MergeKey pop() {
    assert(can_pop() && !taken_);
    taken_ = true;
    return nodes_[1].pop();
  }

  /// One clock. `leaves.dry(run)`: the run's next record is not here yet; else `leaves.order(run)` is its order,
  /// kMergeEnd behind the last, and `leaves.take(run)` gives its key and goes on to the next.
  template <class Leaves>
  void tick(Leaves& leaves) {
    std::size_t request = taken_ ? 1 : 0;  // a node; 0: none. It is served from the next clock on
    taken_ = false;
    for (std::size_t i = 0; i < level_count_; ++i) {
      const bool lowest = i + 1 == level_count_;
      Level& level = levels_[i];
      std::size_t below = 0;
      if (!level.empty() && (lowest || levels_[i + 1].came.count < 2)) {
        const std::size_t node = level.front(i);
        const bool served = lowest ? serve_from_runs(node, leaves) : serve(node, below);
        if (served) level.pop();
      }
      if (request != 0) level.came.push(request);
      request = below;
    }
  }

 private:
  static constexpr std::size_t kMostLevels = 32;

  template <class T>
  struct Two {
    std::array<T, 2> entries{};
    std::uint32_t first = 0;
    std::uint32_t count = 0;
    const T& front() const { return entries[first]; }
    void push(const T& value) {
      assert(count < 2);
      entries[(first + count++) & 1U] = value;
    }
    T pop() {
      const std::uint32_t popped = first;
      first ^= 1U;
      --count;
      return entries[popped];
    }
  };

  /// Requests of a level: those that came, before those of the start.
  struct Level {
    std::size_t unasked = 0;  ///< requests of the start that are left, two for each node
    Two<std::size_t> came;
    bool empty() const { return unasked == 0 && came.count == 0; }
    std::size_t front(std::size_t level) const {
      return came.count > 0 ? came.front() : (std::size_t{2} << level) - (unasked + 1) / 2;
    }
    void pop() {
      if (came.count > 0) {
        came.pop();
      } else {
        --unasked;
      }
    }
  };

  /// Moves the better key of the two nodes below up, if both have one.
  bool serve(std::size_t node, std::size_t& below) {
    const Two<MergeKey>& left = nodes_[2 * node];
    const Two<MergeKey>& right = nodes_[2 * node + 1];
    if (left.count == 0 || right.count == 0) return false;
    below = 2 * node + right_goes_first<Bits>(left.front().order, right.front().order);
    nodes_[node].push(nodes_[below].pop());
    return true;
  }
  template <class Leaves>
  bool serve_from_runs(std::size_t node, Leaves& leaves) {
    const std::size_t left = 2 * node - (std::size_t{1} << level_count_);
    if (leaves.dry(left) || leaves.dry(left + 1)) return false;
    const std::size_t right = right_goes_first<Bits>(leaves.order(left), leaves.order(left + 1));
    nodes_[node].push(leaves.take(left + right));
    return true;
  }

  std::vector<Two<MergeKey>> nodes_;  ///< the root is 1, the children of i are 2 i and 2 i + 1
  std::array<Level, kMostLevels> levels_;
  std::size_t level_count_ = 0;
  bool taken_ = false;  ///< from the root, in this clock
};

}  // namespace cbvh::rtl
