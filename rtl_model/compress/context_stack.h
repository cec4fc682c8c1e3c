// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "rtl_model/bits/machine_bits.h"
#include "rtl_model/datapath/payloads.h"
#include "rtl_model/kernel/channel.h"

namespace cbvh::rtl {

/// The storage of a stack with two reads at the top and one write a cycle. Entries live in place; nothing is allocated
/// after reset.
template <class Entry, std::size_t Capacity>
class StackStorage {
 public:
  std::size_t depth() const { return depth_; }
  static constexpr std::size_t capacity() { return Capacity; }
  /// The entry `below` the top.
  Entry& top(std::size_t below = 0) { return entries_[depth_ - 1 - below]; }
  void drop(std::size_t count) { depth_ -= count; }
  Entry& push() { return entries_[depth_++]; }
  void clear() { depth_ = 0; }

 private:
  std::array<Entry, Capacity> entries_{};
  std::size_t depth_ = 0;
};

/// Why an operation on a stack of this depth is refused, or ok.
template <class Bits, std::size_t Capacity>
constexpr Status stack_status(std::size_t depth, std::size_t pops, bool push) {
  if (taken<Bits>(Corner::stack_underflow, pops > 2 || pops > depth)) return Status::underflow;
  if (taken<Bits>(Corner::stack_overflow, push && depth - pops >= Capacity)) return Status::overflow;
  return Status::ok;
}

/// Traversal contexts of open subtrees. An operation a clock: takes up to two, then adds one. Latency 1. Paper
/// algorithm 1, contextStack.
template <class Bits>
class ContextStack {
 public:
  static constexpr int kLatency = 1;

  ContextStack(Channel<StackOperation>& operations, Channel<StackReply>& replies)
      : operations_(operations), replies_(replies) {}

  void tick() {
    if (!replies_.can_push() || !operations_.can_pop()) return;
    const StackOperation& operation = operations_.pop();
    const std::size_t pops = operation.pops.value();
    StackReply reply;
    const Status status = stack_status<Bits, kContextStackDepth>(stack_.depth(), pops, bool(operation.push));
    if (status == Status::ok) {
      for (std::size_t i = 0; i < pops; ++i) reply.popped[i] = stack_.top(i);
      stack_.drop(pops);
      if (operation.push) stack_.push() = operation.context;
    }
    reply.depth = UInt<6>(stack_.depth());
    reply.status = StatusBits(static_cast<std::uint64_t>(status));
    replies_.push(reply);
  }
  void commit(CommitKey) {}

 private:
  Channel<StackOperation>& operations_;
  Channel<StackReply>& replies_;
  StackStorage<Context, kContextStackDepth> stack_;
};

}  // namespace cbvh::rtl
