// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "rtl_model/compress/context_stack.h"
#include "rtl_model/compress/treelet.h"
#include "rtl_model/datapath/pair_compress.h"
#include "rtl_model/kernel/channel.h"

namespace cbvh::rtl {

/// Collects arriving float pairs into treelets of up to D levels and compresses each treelet anew, top down, with 2^D -
/// 1 node pair compressors: the context is estimated at its root only. Pairs at level D become final. The stack keeps
/// the upper D - 1 levels of every open subtree as floats, and the contexts that the final pairs just below them were
/// written with. Takes a pair a clock while its output queue has room for a row; a final pair leaves 6 D + 1 clocks
/// after the arrival that made it so, or later, one a clock. An arrival takes the places of the queue that its shape
/// asks for along; whether a box is refused is known, and frees them, only when the compressors are through. Paper
/// section 4.3, figure 8.
template <class Bits, int N>
class TreeletCollector {
 public:
  static constexpr int latency(int levels) { return 6 * levels + 1; }

  /// `levels` is D, 1..8.
  TreeletCollector(Channel<StreamJob>& jobs, Channel<FinalPair<N>>& finals, int levels)
      : jobs_(jobs),
        finals_(finals),
        levels_(levels),
        row_(std::size_t{1} << (levels - 1)),
        queue_(final_queue_capacity(levels)),
        unused_(static_cast<std::size_t>(latency(levels))),
        flush_order_(pre_order(levels - 1)),
        nodes_(2 * row_),
        compressed_(2 * row_),
        contexts_(4 * row_),
        written_(4 * row_) {
    for (std::size_t i = 0; i < stack_.capacity(); ++i)
      stack_.push() = Entry{std::vector<Node>(row_), std::vector<Context>(row_)};
    stack_.clear();
  }

  void tick() {
    ++cycle_;
    queue_.output(cycle_, finals_);
    free_unused_places();
    if (!jobs_.can_pop()) return;
    const std::size_t most = jobs_.front().root ? 2 * row_ - 1 : row_;
    if (taken<Bits>(Corner::collector_queue_full, queue_.free() < most + unused_places_)) return;
    accept(jobs_.pop());
  }
  void commit(CommitKey) {}

 private:
  struct Node {
    FloatPair pair;
    Pointer index;
  };
  struct Entry {
    std::vector<Node> nodes;        ///< the upper D - 1 levels, by heap position
    std::vector<Context> contexts;  ///< of the level below them, left to right: what those pairs were written with
  };
  struct Places {
    std::uint64_t ready_cycle = 0;
    std::size_t count = 0;
  };

  void accept(const StreamJob& job) {
    if (shape_status_ == Status::ok) assemble(job);
    if (status_ == Status::ok) {
      status_ = shape_status_;
      if (status_ == Status::ok) compress(job);
      if (status_ == Status::ok) output_row(job);
      if (status_ != Status::ok) refused_index_ = next_index_;
    }
    if (shape_status_ == Status::ok) {
      push_entry();
      if (status_ != Status::ok) leave_places_unused(job);
    }
    if (job.root) finish_tree(job);
    next_index_ = job.root ? 0 : next_index_ + 1;
  }

  bool exists(std::size_t position) const {
    while (position > 1) {
      if (nodes_[position / 2].pair.leaf[position % 2]) return false;
      position /= 2;
    }
    return true;
  }

  /// Puts the arriving pair on top of the treelets of its children.
  void assemble(const StreamJob& job) {
    const std::array<bool, 2> inner = {!job.pair.leaf[0], !job.pair.leaf[1]};
    const std::size_t pops = std::size_t{inner[0]} + std::size_t{inner[1]};
    shape_status_ = stack_status<Bits, kContextStackDepth>(stack_.depth(), pops, true);
    if (shape_status_ != Status::ok) return;
    nodes_[1] = {job.pair, Pointer(next_index_)};
    for (std::size_t child = 0; child < 2; ++child) {
      if (!inner[child]) continue;
      const Entry& entry = stack_.top(child == 0 && inner[1] ? 1 : 0);
      for (std::size_t i = 1; i < row_; ++i) nodes_[graft(i, child)] = entry.nodes[i];
      for (std::size_t i = 0; i < row_; ++i) written_[graft(row_ + i, child)] = entry.contexts[i];
    }
    stack_.drop(pops);
  }

  void compress(const StreamJob& job) {
    for (std::size_t i = 1; i < 2 * row_; ++i) {
      if (!exists(i)) continue;
      const PairJob pair_job{nodes_[i].pair, UInt<1>(i != 1), i != 1 ? contexts_[i] : Context{}, job.registers};
      compressed_[i] = compress_pair<Bits, N>(pair_job);
      if (compressed_[i].status != StatusBits()) {
        status_ = static_cast<Status>(compressed_[i].status.value());
        return;
      }
      if (i == 1) contexts_[1] = compressed_[1].context;
      contexts_[2 * i] = compressed_[i].child_context[0];
      contexts_[2 * i + 1] = compressed_[i].child_context[1];
    }
  }

  /// Level D: final, and the only place where backtracking can start.
  void output_row(const StreamJob& job) {
    for (std::size_t i = row_; i < 2 * row_; ++i) {
      if (!exists(i)) continue;
      taken<Bits>(Corner::collector_row_output, true);
      FinalPair<N>& final_pair = output(i, job);
      for (std::size_t child = 0; child < 2; ++child) {
        const std::size_t below = 2 * i + child;
        if (nodes_[i].pair.leaf[child]) continue;
        if (!invalidates<Bits>(written_[below], contexts_[below], lift<Bits>(job.registers.relative))) continue;
        final_pair.repair[child] = UInt<1>(1);
        final_pair.before[child] = written_[below];
        final_pair.after[child] = contexts_[below];
      }
    }
  }

  void push_entry() {
    Entry& entry = stack_.push();
    for (std::size_t i = 1; i < row_; ++i) entry.nodes[i] = nodes_[i];
    for (std::size_t i = 0; i < row_; ++i) entry.contexts[i] = contexts_[row_ + i];
  }

  FinalPair<N>& output(std::size_t position, const StreamJob& job) {
    return queue_.push(ready_cycle(), nodes_[position].index, compressed_[position].pair, job.registers);
  }
  std::uint64_t ready_cycle() const { return cycle_ + static_cast<unsigned>(latency(levels_)) - 1; }

  /// Flushes what is left on chip; its contexts are the true ones, because the root's estimate is.
  void finish_tree(const StreamJob& job) {
    if (taken<Bits>(Corner::stream_stops_on_error, status_ != Status::ok)) {
      queue_.push_refusal(ready_cycle(), Pointer(refused_index_), status_, job.registers);
    } else {
      for (const std::size_t position : flush_order_) {
        if (!exists(position)) continue;
        taken<Bits>(Corner::collector_flush, true);
        output(position, job);
      }
      taken<Bits>(Corner::stream_single_pair, next_index_ == 0);
      queue_.end_tree(contexts_[1]);
    }
    stack_.clear();
    status_ = shape_status_ = Status::ok;
  }

  /// The places of a refused tree's pair, but for the one that the root tells the refusal in.
  void leave_places_unused(const StreamJob& job) {
    std::size_t places = 0;
    for (std::size_t i = job.root ? 1 : row_; i < 2 * row_; ++i) places += std::size_t{exists(i)};
    if (job.root) --places;
    unused_.push() = {ready_cycle(), places};
    unused_places_ += places;
  }
  void free_unused_places() {
    if (unused_.empty() || unused_.front().ready_cycle > cycle_) return;
    unused_places_ -= unused_.front().count;
    unused_.pop();
  }

  Channel<StreamJob>& jobs_;
  Channel<FinalPair<N>>& finals_;
  const int levels_;
  const std::size_t row_;  ///< pairs of level D: 2^(D-1)
  FinalQueue<N> queue_;
  Fifo<Places> unused_;  ///< taken by pairs of refused trees that are still being compressed
  std::size_t unused_places_ = 0;
  const std::vector<std::size_t> flush_order_;
  StackStorage<Entry, kContextStackDepth> stack_;

  // The treelet in hand, by heap position.
  std::vector<Node> nodes_;
  std::vector<PairResult<N>> compressed_;
  std::vector<Context> contexts_;
  std::vector<Context> written_;

  std::uint64_t cycle_ = 0;
  std::uint64_t next_index_ = 0;
  std::uint64_t refused_index_ = 0;
  Status status_ = Status::ok;        ///< of the tree
  Status shape_status_ = Status::ok;  ///< as far as it is known on arrival
};

}  // namespace cbvh::rtl
