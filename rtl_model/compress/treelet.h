// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <vector>

#include "rtl_model/datapath/payloads.h"
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

/// Final pairs on their way out of a collector: each leaves `latency` clocks after the arrival that made it final, one
/// a clock.
template <int N>
class FinalQueue {
 public:
  explicit FinalQueue(std::size_t capacity) : waiting_(capacity) {}

  std::size_t free() const { return waiting_.free(); }
  FinalPair<N>& push(std::uint64_t ready_cycle) {
    auto& entry = waiting_.push();
    entry = {ready_cycle, {}};
    return entry.pair;
  }
  bool ready(std::uint64_t cycle) const { return !waiting_.empty() && waiting_.front().ready_cycle <= cycle; }
  const FinalPair<N>& front() const { return waiting_.front().pair; }
  void pop() { waiting_.pop(); }

 private:
  struct Waiting {
    std::uint64_t ready_cycle = 0;
    FinalPair<N> pair;
  };
  Fifo<Waiting> waiting_;
};

/// Entries of a collector's output queue: room for several whole rows, so that bursts do not hold arrivals up.
constexpr std::size_t final_queue_capacity(int treelet_levels) {
  return std::max<std::size_t>(64, std::size_t{4} << treelet_levels);
}

}  // namespace cbvh::rtl
