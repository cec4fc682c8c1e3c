// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_model/compress/context_stack.h"
#include "rtl_model/datapath/reencode.h"
#include "rtl_model/kernel/channel.h"

namespace cbvh::rtl {

/// Repairs pairs in memory whose context turned out to be wrong, depth first, child 0 before child 1: reads a line,
/// re-encodes one pair of it, writes that pair back. One access at a time. Paper algorithm 1, function Backtrack;
/// sections 4.1 and 5.3.
template <class Bits, int N>
class BacktrackUnit {
 public:
  BacktrackUnit(Channel<RepairJob>& jobs, Channel<MemoryRequest<N>>& requests, Channel<MemoryLine<N>>& lines,
                Channel<UInt<32>>& done)
      : jobs_(jobs), requests_(requests), lines_(lines), done_(done) {}

  void tick() {
    switch (state_) {
      case State::idle:
        if (!jobs_.can_pop()) return;
        current_ = jobs_.pop();
        repairs_ = 0;
        state_ = State::read;
        [[fallthrough]];
      case State::read:
        if (!requests_.can_push()) return;
        requests_.push({UInt<1>(0), line(), slot_mask(), {}});
        state_ = State::write;
        return;
      case State::write:
        if (!lines_.can_pop() || !requests_.can_push()) return;
        repair(lines_.pop());
        return;
      case State::report:
        if (!done_.can_push()) return;
        done_.push(UInt<32>(repairs_));
        state_ = State::idle;
        return;
    }
  }
  void commit(CommitKey) {}

 private:
  enum class State { idle, read, write, report };

  UInt<kLineBits> line() const { return bits<kPointerBits - 1, 2>(current_.pointer); }
  std::size_t slot() const { return bits<1, 0>(current_.pointer).value(); }
  UInt<kPairsPerLine> slot_mask() const { return UInt<kPairsPerLine>(std::uint64_t{1} << slot()); }

  void repair(const MemoryLine<N>& stored) {
    const auto fixed = reencode<Bits, N>(stored.pairs[slot()], current_.before, current_.after, current_.registers);
    MemoryRequest<N> request{UInt<1>(1), line(), slot_mask(), {}};
    request.pairs[slot()] = fixed.pair;
    requests_.push(request);
    ++repairs_;
    choose_next(fixed);
  }

  void choose_next(const Reencoded<N>& fixed) {
    const auto child_job = [&](std::size_t child) {
      return RepairJob{fixed.pair.child[child].pointer, fixed.child_before[child], fixed.child_after[child],
                       current_.registers};
    };
    state_ = State::read;
    if (taken<Bits>(Corner::backtrack_both_children, fixed.repair[0] && fixed.repair[1])) {
      waiting_.push() = child_job(1);
      current_ = child_job(0);
    } else if (taken<Bits>(Corner::backtrack_recurses, fixed.repair[0] || fixed.repair[1])) {
      current_ = child_job(fixed.repair[0] ? 0 : 1);
    } else if (taken<Bits>(Corner::backtrack_stops, waiting_.depth() > 0)) {
      current_ = waiting_.top();
      waiting_.drop(1);
    } else {
      state_ = State::report;
    }
  }

  Channel<RepairJob>& jobs_;
  Channel<MemoryRequest<N>>& requests_;
  Channel<MemoryLine<N>>& lines_;
  Channel<UInt<32>>& done_;
  State state_ = State::idle;
  RepairJob current_;
  StackStorage<RepairJob, kContextStackDepth> waiting_;  ///< second children; one a level at most
  std::uint64_t repairs_ = 0;
};

}  // namespace cbvh::rtl
