// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <bit>
#include <cassert>
#include <cstdint>
#include <vector>

#include "rtl_model/memory/line_port.h"

namespace cbvh::rtl {

/// A line waiting for its turn in a channel.
struct DramRequest {
  std::uint32_t line = 0;
  std::uint32_t row = 0;
  std::uint64_t age = 0;      ///< number of its acceptance
  std::uint64_t arrival = 0;  ///< clock of it
  UInt<kWordsPerLine> mask;   ///< of a write
  std::uint16_t answer = 0;   ///< of a read: place in its port's reorder buffer
  std::uint8_t bank = 0;
  std::uint8_t port = 0;
  bool activated = false;   ///< its row was opened for it
  bool precharged = false;  ///< another was closed for it
};

/// The reads, or the writes, that wait in a channel. In hardware a memory searched by content; here a list for each
/// bank, oldest first, with the oldest request to the bank's open row at hand.
class DramQueue {
 public:
  static constexpr int kNone = -1;

  DramQueue(unsigned depth, unsigned banks) : slots_(depth), banks_(banks) {
    for (unsigned i = depth; i-- > 0;) release(static_cast<int>(i));
  }

  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  bool full() const { return free_ == kNone; }
  DramRequest& operator[](int slot) { return slots_[index(slot)].request; }
  const DramRequest& operator[](int slot) const { return slots_[index(slot)].request; }

  std::uint32_t busy_banks() const { return busy_banks_; }  ///< a bit each: something waits for it
  std::uint32_t hit_banks() const { return hit_banks_; }    ///< something waits for its open row
  int oldest(unsigned bank) const { return banks_[bank].first; }
  int oldest_hit(unsigned bank) const { return banks_[bank].hit; }

  /// The slot of the request to a line, if one waits.
  int find(unsigned bank, std::uint32_t line) const {
    if (lines_with_[line % kFilter] == 0) return kNone;
    int slot = banks_[bank].first;
    while (slot != kNone && slots_[index(slot)].request.line != line) slot = slots_[index(slot)].next;
    return slot;
  }

  /// `hit`: the request is for the row that is open.
  void push(const DramRequest& request, bool hit) {
    assert(!full());
    const int slot = free_;
    Slot& entry = slots_[index(slot)];
    free_ = entry.next;
    Bank& bank = banks_[request.bank];
    entry = {request, kNone, bank.last};
    (bank.last == kNone ? bank.first : slots_[index(bank.last)].next) = slot;
    bank.last = slot;
    if (hit && bank.hit == kNone) set_hit(request.bank, slot);
    busy_banks_ |= 1u << request.bank;
    ++lines_with_[request.line % kFilter];
    ++size_;
  }

  void remove(int slot) {
    const Slot& entry = slots_[index(slot)];
    const DramRequest& request = entry.request;
    Bank& bank = banks_[request.bank];
    if (bank.hit == slot) set_hit(request.bank, next_of_row(entry.next, request.row));
    (entry.previous == kNone ? bank.first : slots_[index(entry.previous)].next) = entry.next;
    (entry.next == kNone ? bank.last : slots_[index(entry.next)].previous) = entry.previous;
    if (bank.first == kNone) busy_banks_ &= ~(1u << request.bank);
    --lines_with_[request.line % kFilter];
    --size_;
    release(slot);
  }

  void row_opened(unsigned bank, std::uint32_t row) { set_hit(bank, next_of_row(banks_[bank].first, row)); }
  void row_closed(unsigned bank) { set_hit(bank, kNone); }

 private:
  static constexpr std::size_t kFilter = 256;
  struct Slot {
    DramRequest request;
    int next = kNone;
    int previous = kNone;
  };
  struct Bank {
    int first = kNone;
    int last = kNone;
    int hit = kNone;
  };

  static std::size_t index(int slot) { return static_cast<std::size_t>(slot); }
  void release(int slot) {
    slots_[index(slot)].next = free_;
    free_ = slot;
  }
  int next_of_row(int slot, std::uint32_t row) const {
    while (slot != kNone && slots_[index(slot)].request.row != row) slot = slots_[index(slot)].next;
    return slot;
  }
  void set_hit(unsigned bank, int slot) {
    banks_[bank].hit = slot;
    hit_banks_ = slot == kNone ? hit_banks_ & ~(1u << bank) : hit_banks_ | 1u << bank;
  }

  std::vector<Slot> slots_;
  std::vector<Bank> banks_;
  std::array<std::uint8_t, kFilter> lines_with_{};  ///< requests by the low bits of their line: zero finds nothing
  std::size_t size_ = 0;
  int free_ = kNone;
  std::uint32_t busy_banks_ = 0;
  std::uint32_t hit_banks_ = 0;
};

}  // namespace cbvh::rtl
