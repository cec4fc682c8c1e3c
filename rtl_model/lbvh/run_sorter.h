// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_model/bits/machine_bits.h"
#include "rtl_model/datapath/lbvh_payloads.h"
#include "rtl_model/kernel/channel.h"
#include "rtl_model/lbvh/key_heap.h"

namespace cbvh::rtl {

/// Records that the 256 KiB scratchpad of the paper holds.
constexpr std::size_t kSorterCapacity = (std::size_t{256} << 10) / 32;

/// Puts the records of a scene into sorted runs by replacement selection: in each clock the smallest record that still
/// fits the run leaves the scratchpad, and a new one takes its place; a record with a smaller code than the one that
/// leaves must wait for the next run. Runs are as long as the scratchpad at least (the last one excepted), twice as
/// long for records in random order, one for sorted ones. n records take n + min(n, capacity) clocks; the first result
/// comes min(n, capacity) + 1 clocks after the first record was taken.
///
/// Stable: records with equal codes keep their order of arrival in a run, and an earlier one is never in a later run.
/// So a merge that prefers the earlier run at equal codes gives the stable sort of the scene.
///
/// Memory: `capacity` records of 32 bytes, one read and one write of the same place a clock; beside them a KeyHeap with
/// as many keys of run (one bit: this or the next), code and arrival. Paper section 5.3.
template <class Bits>
class RunSorter {
 public:
  /// `capacity` is at least 2.
  RunSorter(Channel<SortItem>& items, Channel<SortItem>& sorted, std::size_t capacity = kSorterCapacity)
      : items_(items), sorted_(sorted), heap_(capacity), scratchpad_(capacity) {}

  void tick() {
    if (draining_) {
      if (sorted_.can_push()) drain();
    } else if (items_.can_pop()) {
      if (held_ < scratchpad_.size()) {
        fill(items_.pop());
      } else if (sorted_.can_push()) {
        replace(items_.pop());
      }
    }
  }
  void commit(CommitKey) {}

 private:
  static constexpr int kArrivalBits = kPointerBits + 1;
  static constexpr std::uint64_t kNextRunBit = std::uint64_t{1} << (kArrivalBits + kMortonBits);

  std::uint64_t run_bit() const { return odd_run_ ? kNextRunBit : 0; }

  HeapKey key_of(const SortItem& item, std::uint64_t run, std::uint32_t slot) {
    return {run | item.record.code.value() << kArrivalBits | arrivals_++, slot};
  }

  void fill(const SortItem& item) {
    const auto slot = static_cast<std::uint32_t>(held_);
    scratchpad_[slot] = item.record;
    heap_.insert(key_of(item, run_bit(), slot), held_);
    ++held_;
    ++held_of_run_;
    draining_ = bool(item.last);
  }

  void replace(const SortItem& item) {
    const std::uint32_t slot = heap_.first().slot;
    const bool too_late =
        taken<Bits>(Corner::sorter_next_run, item.record.code.value() < scratchpad_[slot].code.value());
    held_of_run_ -= too_late;
    give(scratchpad_[slot], false);
    heap_.replace_first(key_of(item, too_late ? run_bit() ^ kNextRunBit : run_bit(), slot), run_bit());
    scratchpad_[slot] = item.record;
    draining_ = bool(item.last);
    end_run();
  }

  void drain() {
    --held_;
    --held_of_run_;
    give(scratchpad_[heap_.first().slot], held_ == 0);
    heap_.replace_first({}, run_bit());
    end_run();
    if (held_ > 0) return;
    draining_ = false;
    arrivals_ = 0;
  }

  void give(const SortRecord& record, bool last) { sorted_.push({record, UInt<1>(held_of_run_ == 0), UInt<1>(last)}); }
  /// When no record of the run is left, all that are held belong to the next one.
  void end_run() {
    if (held_of_run_ > 0) return;
    held_of_run_ = held_;
    odd_run_ = !odd_run_;
  }

  Channel<SortItem>& items_;
  Channel<SortItem>& sorted_;
  KeyHeap heap_;
  std::vector<SortRecord> scratchpad_;
  std::size_t held_ = 0;         ///< records in the scratchpad
  std::size_t held_of_run_ = 0;  ///< of them, those of the run that is being given away
  std::uint64_t arrivals_ = 0;   ///< of this scene
  bool odd_run_ = false;
  bool draining_ = false;
};

}  // namespace cbvh::rtl
