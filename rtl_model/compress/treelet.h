// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <vector>

#include "rtl_model/datapath/payloads.h"
#include "rtl_model/kernel/channel.h"
#include "rtl_model/kernel/fifo.h"

/// Treelets are heaps: position 1 is the root, 2i and 2i+1 are the pairs below position i, level L starts at position
/// 2^(L-1).
namespace cbvh::rtl {

/// Where position i of the treelet below child `child` stands in the treelet of the parent.
constexpr std::size_t graft(std::size_t position, std::size_t child) {
  const std::size_t level_start = std::bit_floor(position);
  return position + level_start * (1 + child);
}

/// Positions of a treelet in depth-first pre-order, for those levels that are still on chip when the root arrives.
inline std::vector<std::size_t> pre_order(int levels) {
  std::vector<std::size_t> order;
  const std::size_t end = std::size_t{1} << levels;
  const auto visit = [&](auto&& self, std::size_t position) -> void {
    if (position >= end) return;
    order.push_back(position);
    self(self, 2 * position);
    self(self, 2 * position + 1);
  };
  visit(visit, 1);
  return order;
}

/// Final pairs on their way out of a collector: each leaves in the cycle it is ready or later, one a clock.
template <int N>
class FinalQueue {
 public:
  explicit FinalQueue(std::size_t capacity) : waiting_(capacity) {}

  std::size_t free() const { return waiting_.free(); }

  FinalPair<N>& push(std::uint64_t ready_cycle, Pointer index, const NodePair<N>& pair,
                     const SceneRegisters& registers) {
    newest_ = &push_empty(ready_cycle, index, registers);
    newest_->pair = pair;
    return *newest_;
  }
  /// The one word about a tree of which pair `index` was refused.
  void push_refusal(std::uint64_t ready_cycle, Pointer index, Status status, const SceneRegisters& registers) {
    auto& refusal = push_empty(ready_cycle, index, registers);
    refusal.status = StatusBits(static_cast<std::uint64_t>(status));
    refusal.last = UInt<1>(1);
  }
  /// The pair pushed last ends its tree.
  void end_tree(const Context& root) {
    newest_->last = UInt<1>(1);
    newest_->root = root;
  }

  void output(std::uint64_t cycle, Channel<FinalPair<N>>& finals) {
    if (waiting_.empty() || waiting_.front().ready_cycle > cycle || !finals.can_push()) return;
    finals.push(waiting_.front().pair);
    waiting_.pop();
  }

 private:
  struct Waiting {
    std::uint64_t ready_cycle = 0;
    FinalPair<N> pair;
  };
  FinalPair<N>& push_empty(std::uint64_t ready_cycle, Pointer index, const SceneRegisters& registers) {
    auto& entry = waiting_.push();
    entry = {ready_cycle, {}};
    entry.pair.index = index;
    entry.pair.registers = registers;
    return entry.pair;
  }

  Fifo<Waiting> waiting_;
  FinalPair<N>* newest_ = nullptr;
};

/// Entries of a collector's output queue: room for several whole rows, so that bursts do not hold arrivals up.
constexpr std::size_t final_queue_capacity(int treelet_levels) {
  return std::max<std::size_t>(64, std::size_t{8} << treelet_levels);
}

}  // namespace cbvh::rtl
