// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_model/bits/machine_bits.h"
#include "rtl_model/datapath/payloads.h"
#include "rtl_model/kernel/channel.h"
#include "rtl_model/kernel/fifo.h"

namespace cbvh::rtl {

/// The memory side of the stream compressor. Combines final pairs into 64-byte lines, hands their repairs to the
/// backtrack unit in order, and lets that unit's accesses through to the one memory port. A line that is still being
/// combined is written before a repair may read it: the memory serves requests in order, so that is all the ordering
/// there is to keep. Paper section 5.3.
template <class Bits, int N>
class LineCombiner {
 public:
  static constexpr std::size_t kRepairQueue = 16;

  LineCombiner(Channel<FinalPair<N>>& finals, Channel<RepairJob>& repair_jobs, Channel<UInt<32>>& repairs_done,
               Channel<MemoryRequest<N>>& repair_requests, Channel<MemoryRequest<N>>& memory,
               Channel<StreamReport>& reports)
      : finals_(finals),
        repair_jobs_(repair_jobs),
        repairs_done_(repairs_done),
        repair_requests_(repair_requests),
        memory_(memory),
        reports_(reports) {}

  void tick() {
    memory_free_ = memory_.can_push();
    if (repairs_done_.can_pop()) {
      report_.repairs = truncate<32>(report_.repairs + repairs_done_.pop());
      --unfinished_repairs_;
    }
    if (!repair_queue_.empty() && repair_jobs_.can_push()) {
      repair_jobs_.push(repair_queue_.front());
      repair_queue_.pop();
    }
    if (repair_requests_.can_pop()) forward_repair();
    if (finishing_) {
      finish();
    } else if (finals_.can_pop() && repair_queue_.free() >= 2) {
      take_final();
    }
  }
  void commit(CommitKey) {}

 private:
  void send(const MemoryRequest<N>& request) {
    memory_.push(request);
    memory_free_ = false;
  }
  void send_line() {
    send(line_);
    line_ = {};
  }
  bool holds_line() const { return bool(line_.write); }

  void forward_repair() {
    if (!memory_free_) return;
    const bool wanted = holds_line() && line_.line == repair_requests_.front().line;
    if (taken<Bits>(Corner::combiner_flushes_for_read, wanted)) {
      send_line();
    } else {
      send(repair_requests_.pop());
    }
  }

  void take_final() {
    const FinalPair<N>& next = finals_.front();
    if (next.status == StatusBits()) {
      const auto line = bits<kPointerBits - 1, 2>(next.index);
      const bool same_line = taken<Bits>(Corner::combiner_merges, holds_line() && line_.line == line);
      if (holds_line() && !same_line) {
        if (!memory_free_) return;
        send_line();
      }
      const std::size_t slot = bits<1, 0>(next.index).value();
      line_.write = UInt<1>(1);
      line_.line = line;
      line_.mask = line_.mask | UInt<kPairsPerLine>(std::uint64_t{1} << slot);
      line_.pairs[slot] = next.pair;
      queue_repairs(next);
    }
    if (next.last) {
      report_.last_index = next.status == StatusBits() ? highest_index(next) : next.index;
      report_.root = next.root;
      report_.status = next.status;
      finishing_ = true;
      highest_index_ = Pointer();
    } else {
      highest_index_ = highest_index(next);
    }
    finals_.pop();
  }

  Pointer highest_index(const FinalPair<N>& next) const {
    return next.index.value() > highest_index_.value() ? next.index : highest_index_;
  }

  void queue_repairs(const FinalPair<N>& next) {
    for (std::size_t child = 0; child < 2; ++child) {
      if (!next.repair[child]) continue;
      repair_queue_.push() = {next.pair.child[child].pointer, next.before[child], next.after[child], next.registers};
      ++unfinished_repairs_;
    }
  }

  /// The tree is complete when every repair is done and the last line is on its way.
  void finish() {
    if (unfinished_repairs_ > 0 || !reports_.can_push() || !memory_free_) return;
    if (holds_line()) send_line();
    if (report_.status != StatusBits()) report_.repairs = UInt<32>();  // of a refused tree nothing is told
    reports_.push(report_);
    report_ = {};
    finishing_ = false;
  }

  Channel<FinalPair<N>>& finals_;
  Channel<RepairJob>& repair_jobs_;
  Channel<UInt<32>>& repairs_done_;
  Channel<MemoryRequest<N>>& repair_requests_;
  Channel<MemoryRequest<N>>& memory_;
  Channel<StreamReport>& reports_;
  Fifo<RepairJob> repair_queue_{kRepairQueue};
  MemoryRequest<N> line_;  ///< the line being combined, once `write` is set
  StreamReport report_;
  Pointer highest_index_;
  std::uint64_t unfinished_repairs_ = 0;
  bool memory_free_ = false;
  bool finishing_ = false;
};

}  // namespace cbvh::rtl
