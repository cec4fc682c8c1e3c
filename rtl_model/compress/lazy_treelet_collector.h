// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <vector>

#include "rtl_model/compress/context_stack.h"
#include "rtl_model/compress/treelet.h"
#include "rtl_model/datapath/pair_compress.h"
#include "rtl_model/datapath/reencode.h"
#include "rtl_model/kernel/channel.h"

namespace cbvh::rtl {

/// Writes the same pairs as TreeletCollector with one node pair compressor instead of 2^D - 1. The stack keeps the
/// upper D - 1 levels of every open subtree compressed, with the context of its root; an arriving pair is compressed
/// once, and what its context invalidates on chip is re-encoded in place, a pair a clock, while arrivals wait. A final
/// pair leaves 7 clocks after the arrival that made it so, and one more for each pair re-encoded before.
template <class Bits, int N>
class LazyTreeletCollector {
 public:
  static constexpr int kCompressorLatency = 6;

  /// `levels` is D, 1..8.
  LazyTreeletCollector(Channel<StreamJob>& jobs, Channel<FinalPair<N>>& finals, int levels)
      : jobs_(jobs),
        finals_(finals),
        row_(std::size_t{1} << (levels - 1)),
        queue_(final_queue_capacity(levels)),
        flush_order_(pre_order(levels - 1)),
        nodes_(2 * row_) {
    for (std::size_t i = 0; i < stack_.capacity(); ++i) stack_.push() = Entry{std::vector<Node>(row_), {}};
    stack_.clear();
  }

  void tick() {
    ++cycle_;
    queue_.output(cycle_, finals_);
    if (!jobs_.can_pop() || repairing_until_ > cycle_ + kCompressorLatency) return;
    const std::size_t most = jobs_.front().root ? 2 * row_ - 1 : row_;
    if (taken<Bits>(Corner::collector_queue_full, queue_.free() < most)) return;
    accept(jobs_.pop());
  }
  void commit(CommitKey) {}

  /// Pairs re-encoded on chip so far: with the pairs that arrived, the work of the compressor.
  std::uint64_t on_chip_repairs() const { return on_chip_repairs_; }

 private:
  struct Node {
    NodePair<N> pair;
    Pointer index;
    std::array<UInt<1>, 2> repair;  ///< of a pair at level D: its child in memory must be re-encoded
    std::array<Context, 2> before;
    std::array<Context, 2> after;
  };
  struct Entry {
    std::vector<Node> nodes;  ///< the upper D - 1 levels, by heap position
    Context context;          ///< what the root was compressed with
  };

  void accept(const StreamJob& job) {
    const std::uint64_t repairs_before = on_chip_repairs_;
    if (status_ == Status::ok) {
      take_pair(job);
      if (status_ != Status::ok) refused_index_ = next_index_;
    }
    repairing_until_ = std::max(repairing_until_, cycle_ + kCompressorLatency) + on_chip_repairs_ - repairs_before;
    if (status_ == Status::ok) {
      output_row(job);
      push_entry();
    }
    if (job.root) finish_tree(job);
    next_index_ = job.root ? 0 : next_index_ + 1;
  }

  void take_pair(const StreamJob& job) {
    const std::array<bool, 2> inner = {!job.pair.leaf[0], !job.pair.leaf[1]};
    const std::size_t pops = std::size_t{inner[0]} + std::size_t{inner[1]};
    status_ = stack_status<Bits, kContextStackDepth>(stack_.depth(), pops, true);
    if (status_ != Status::ok) return;
    const auto compressed = compress_pair<Bits, N>({job.pair, UInt<1>(0), {}, job.registers});
    status_ = static_cast<Status>(compressed.status.value());
    if (status_ != Status::ok) return;
    context_ = compressed.context;
    nodes_[1] = {compressed.pair, Pointer(next_index_), {}, {}, {}};
    for (std::size_t child = 0; child < 2; ++child) {
      if (!inner[child]) continue;
      const Entry& entry = stack_.top(child == 0 && inner[1] ? 1 : 0);
      for (std::size_t i = 1; i < row_; ++i) nodes_[graft(i, child)] = entry.nodes[i];
      if (invalidates<Bits>(entry.context, compressed.child_context[child], lift<Bits>(job.registers.relative))) {
        repair_below(1, child, entry.context, compressed.child_context[child], job.registers);
      }
    }
    stack_.drop(pops);
  }

  /// The pair below `position` must change its context: here if it is on chip, later in memory if not.
  void repair_below(std::size_t position, std::size_t child, const Context& before, const Context& after,
                    const SceneRegisters& registers) {
    Node& parent = nodes_[position];
    const std::size_t below = 2 * position + child;
    if (below >= 2 * row_) {
      parent.repair[child] = UInt<1>(1);
      parent.before[child] = before;
      parent.after[child] = after;
      return;
    }
    const auto fixed = reencode<Bits, N>(nodes_[below].pair, before, after, registers);
    nodes_[below].pair = fixed.pair;
    ++on_chip_repairs_;
    for (std::size_t grandchild = 0; grandchild < 2; ++grandchild) {
      if (!fixed.repair[grandchild]) continue;
      repair_below(below, grandchild, fixed.child_before[grandchild], fixed.child_after[grandchild], registers);
    }
  }

  bool exists(std::size_t position) const {
    while (position > 1) {
      if (nodes_[position / 2].pair.child[position % 2].leaf) return false;
      position /= 2;
    }
    return true;
  }

  void output_row(const StreamJob& job) {
    for (std::size_t i = row_; i < 2 * row_; ++i) {
      if (!exists(i)) continue;
      taken<Bits>(Corner::collector_row_output, true);
      FinalPair<N>& final_pair = output(i, job);
      final_pair.repair = nodes_[i].repair;
      final_pair.before = nodes_[i].before;
      final_pair.after = nodes_[i].after;
    }
  }

  void push_entry() {
    Entry& entry = stack_.push();
    for (std::size_t i = 1; i < row_; ++i) entry.nodes[i] = nodes_[i];
    entry.context = context_;
  }

  FinalPair<N>& output(std::size_t position, const StreamJob& job) {
    return queue_.push(repairing_until_, nodes_[position].index, nodes_[position].pair, job.registers);
  }

  void finish_tree(const StreamJob& job) {
    if (taken<Bits>(Corner::stream_stops_on_error, status_ != Status::ok)) {
      queue_.push_refusal(repairing_until_, Pointer(refused_index_), status_, job.registers);
    } else {
      for (const std::size_t position : flush_order_) {
        if (!exists(position)) continue;
        taken<Bits>(Corner::collector_flush, true);
        output(position, job);
      }
      taken<Bits>(Corner::stream_single_pair, next_index_ == 0);
      queue_.end_tree(context_);
    }
    stack_.clear();
    status_ = Status::ok;
  }

  Channel<StreamJob>& jobs_;
  Channel<FinalPair<N>>& finals_;
  const std::size_t row_;  ///< pairs of level D: 2^(D-1)
  FinalQueue<N> queue_;
  const std::vector<std::size_t> flush_order_;
  StackStorage<Entry, kContextStackDepth> stack_;
  std::vector<Node> nodes_;  ///< the treelet in hand, by heap position
  Context context_;          ///< of its root

  std::uint64_t cycle_ = 0;
  std::uint64_t repairing_until_ = 0;  ///< the cycle in which the newest arrival leaves the re-encoder
  std::uint64_t on_chip_repairs_ = 0;
  std::uint64_t next_index_ = 0;
  std::uint64_t refused_index_ = 0;
  Status status_ = Status::ok;
};

}  // namespace cbvh::rtl
