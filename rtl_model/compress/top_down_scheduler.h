// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>

#include "rtl_model/compress/context_stack.h"
#include "rtl_model/datapath/node_words.h"
#include "rtl_model/datapath/record_words.h"
#include "rtl_model/datapath/refit_payloads.h"
#include "rtl_model/kernel/fifo.h"

namespace cbvh::rtl {

/// Where a top-down compression finds its arrays, each from the beginning of a line on.
struct TopDownAddresses {
  LineAddress float_pairs;  ///< a line each
  LineAddress pairs;        ///< packed, four to a line
};

/// Top-down compression of a float tree in memory, as a window that slides from the root pair, the last, down to pair
/// 0. Float pairs are asked for in descending order as soon as the window has room, and come to their place in it. A
/// pair goes to the compressor once it and its context are there, those nearest the root first, one a clock, in any
/// order otherwise; results give contexts to their children, in the window or parked until the child's pair comes.
/// Pairs leave the window in order, one a clock, and are checked: each must be the one that the top of a stack
/// announces, and its children come after it and before all that is announced already. Four make a line. A tree that is
/// none, is deeper than the stack or has a box that is refused ends with its first bad pair in that order; nothing more
/// is written. Memory: a window of 64 pairs with contexts and results (64 x 900 bits, two contexts written a clock), 32
/// parked contexts that are found by their pointer, 32 pointers of announced pairs.
template <class Bits, int N>
class TopDownScheduler {
 public:
  static constexpr std::size_t kWindow = 64;

  TopDownScheduler(Channel<TopDownCommand>& commands, LinePort reads, LinePort writes, Channel<PairJob>& jobs,
                   Channel<PairResult<N>>& results, Channel<StreamReport>& reports, const TopDownAddresses& addresses)
      : commands_(commands),
        reads_(reads),
        writes_(writes),
        jobs_(jobs),
        results_(results),
        reports_(reports),
        addresses_(addresses) {}

  void tick() {
    if (state_ == State::idle) {
      if (commands_.can_pop()) start(commands_.pop());
      return;
    }
    if (results_.can_pop()) take_result(results_.pop());
    if (arrived_ > asked_ && reads_.answers->can_pop()) take_pair(reads_.answers->pop().words);
    if (state_ == State::running) {
      if (asked_ > 0 && checked_ - asked_ < kWindow && reads_.requests->can_push()) ask();
      if (ready_ != 0 && jobs_.can_push()) compress();
      check();
    } else if (state_ == State::refused) {
      if (arrived_ == asked_ && in_flight_.empty() && reports_.can_push()) report();
    } else if (writes_.answers->can_pop() && reports_.can_push()) {
      writes_.answers->pop();
      report();
    }
  }
  void commit(CommitKey) {}

 private:
  enum class State { idle, running, refused, written };
  struct Slot {
    FloatPair pair;
    Context context;
    bool done = false;
    PairResult<N> result;
  };
  struct Parked {
    std::uint64_t index = 0;
    Context context;
  };

  void start(const TopDownCommand& command) {
    command_ = command;
    asked_ = arrived_ = checked_ = pairs();
    ready_ = 0;
    parked_count_ = 0;
    announced_.clear();
    announced_.push() = pairs() - 1;
    line_ = {};
    report_ = {Pointer(pairs() - 1), {}, {}, {}};
    state_ = State::running;
  }
  std::uint64_t pairs() const { return command_.pairs.value(); }
  Slot& slot(std::uint64_t index) { return window_[index % kWindow]; }
  static std::uint64_t bit_of(std::uint64_t index) { return std::uint64_t{1} << index % kWindow; }

  void ask() {
    LineRequest request;
    request.line = truncate<kLineAddressBits>(addresses_.float_pairs + Pointer(--asked_));
    reads_.requests->push(request);
  }

  void take_pair(const LineWords& words) {
    const std::uint64_t index = --arrived_;
    Slot& place = slot(index);
    place.pair = float_pair_at(words);
    place.done = false;
    if (index + 1 == pairs()) ready_ |= bit_of(index);  // the root's context is its own estimate
    for (std::size_t i = 0; i < parked_count_; ++i) {
      if (parked_[i].index != index) continue;
      give(place, index, parked_[i].context);
      parked_[i] = parked_[--parked_count_];
      break;
    }
  }
  /// A pair with two parents gets a context twice: check() meets the second parent before it meets the pair.
  void give(Slot& place, std::uint64_t index, const Context& context) {
    place.context = context;
    ready_ |= bit_of(index);
  }

  /// The ready pair nearest the root.
  void compress() {
    const auto below = static_cast<std::uint64_t>(
        std::countl_zero(std::rotl(ready_, static_cast<int>(kWindow - 1 - (checked_ - 1) % kWindow))));
    const std::uint64_t index = checked_ - 1 - below;
    const Slot& place = slot(index);
    jobs_.push({place.pair, UInt<1>(index + 1 != pairs()), place.context, command_.registers});
    in_flight_.push() = index;
    ready_ &= ~bit_of(index);
  }

  void take_result(const PairResult<N>& result) {
    const std::uint64_t index = in_flight_.front();
    in_flight_.pop();
    Slot& place = slot(index);
    place.result = result;
    place.done = true;
    for (std::size_t child = 0; child < 2; ++child) {
      const std::uint64_t below = place.pair.pointer[child].value();
      if (place.pair.leaf[child] || below >= index) continue;
      if (!taken<Bits>(Corner::top_down_parks, below < arrived_)) {
        give(slot(below), below, result.child_context[child]);
      } else if (parked_count_ < parked_.size()) {  // else check() will meet too many levels first
        parked_[parked_count_++] = {below, result.child_context[child]};
      }
    }
  }

  /// The next pair in order leaves the window.
  void check() {
    const std::uint64_t index = checked_ - 1;
    if (index < arrived_) return;
    const Slot& place = slot(index);
    if (announced_.depth() == 0 || announced_.top() != index) return refuse(Status::underflow, index);
    if (!place.done) return;
    if (place.result.status != StatusBits()) return refuse(static_cast<Status>(place.result.status.value()), index);
    const std::size_t place_in_line = index % kPairsPerLine;
    if (place_in_line == 0 && !writes_.requests->can_push()) return;
    announced_.drop(1);
    for (std::size_t child = 0; child < 2; ++child) {
      if (place.pair.leaf[child]) continue;
      const std::uint64_t below = place.pair.pointer[child].value();
      const bool in_order = below < index && (announced_.depth() == 0 || below > announced_.top());
      if (!in_order) return refuse(Status::underflow, index);
      if (announced_.depth() == announced_.capacity()) return refuse(Status::overflow, index);
      announced_.push() = below;
    }
    if (index + 1 == pairs()) report_.root = place.result.context;
    line_.pairs[place_in_line] = place.result.pair;
    line_.mask = line_.mask | UInt<kPairsPerLine>(std::uint64_t{1} << place_in_line);
    if (place_in_line == 0) write(index);
    --checked_;
  }
  void write(std::uint64_t index) {
    line_.line = UInt<kLineBits>(index / kPairsPerLine);
    LineRequest request = pack_write(line_, addresses_.pairs);
    request.acknowledge = UInt<1>(index == 0);
    writes_.requests->push(request);
    line_ = {};
    if (index == 0) state_ = State::written;
  }

  void refuse(Status status, std::uint64_t index) {
    report_ = {Pointer(index), {}, {}, StatusBits(static_cast<std::uint64_t>(status))};
    state_ = State::refused;
  }
  void report() {
    reports_.push(report_);
    state_ = State::idle;
  }

  Channel<TopDownCommand>& commands_;
  const LinePort reads_;
  const LinePort writes_;
  Channel<PairJob>& jobs_;
  Channel<PairResult<N>>& results_;
  Channel<StreamReport>& reports_;
  const TopDownAddresses addresses_;
  TopDownCommand command_;
  std::array<Slot, kWindow> window_{};  ///< by the low bits of the index
  std::uint64_t ready_ = 0;             ///< slots that wait for the compressor
  Fifo<std::uint64_t> in_flight_{16};   ///< pairs in the compressor
  std::array<Parked, kContextStackDepth> parked_{};
  std::size_t parked_count_ = 0;
  StackStorage<std::uint64_t, kContextStackDepth> announced_;
  MemoryRequest<N> line_;  ///< pairs that have left the window
  StreamReport report_;
  State state_ = State::idle;
  // All pairs from here on have been asked for, have come, have left the window.
  std::uint64_t asked_ = 0;
  std::uint64_t arrived_ = 0;
  std::uint64_t checked_ = 0;
};

}  // namespace cbvh::rtl
