// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_model/datapath/refit_payloads.h"
#include "rtl_model/memory/line_reads.h"

namespace cbvh::rtl {

/// Reads an array from memory, line after line with up to `outstanding` reads in flight, and gives an item a clock. For
/// each command one pass. The first item comes 3 clocks after the command was taken and the memory's latency, and a
/// pass takes as many clocks as it has items if a line's reads are answered as fast. item_of(line, slot, last) takes
/// item `slot` out of a line. Memory: `outstanding` lines of 512 bits.
template <class Item, std::size_t ItemsPerLine, auto item_of>
class ArrayReader {
 public:
  ArrayReader(Channel<ReadCommand>& commands, LinePort memory, Channel<Item>& items, std::size_t outstanding = 16)
      : commands_(commands), items_(items), reads_(memory, outstanding) {}

  void tick() {
    reads_.take_answer();
    if (items_left_ == 0) {
      if (!commands_.can_pop()) return;
      const ReadCommand& command = commands_.pop();
      next_line_ = command.first_line.value();
      items_left_ = command.items.value();
      lines_left_ = (items_left_ + ItemsPerLine - 1) / ItemsPerLine;
      return;
    }
    if (lines_left_ > 0 && reads_.can_request()) {
      reads_.request(LineAddress(next_line_++));
      --lines_left_;
    }
    if (reads_.has_line() && items_.can_push()) give_item();
  }
  void commit(CommitKey) {}

 private:
  void give_item() {
    const bool last = --items_left_ == 0;
    items_.push(item_of(reads_.line(), slot_, UInt<1>(last)));
    slot_ = last ? 0 : (slot_ + 1) % ItemsPerLine;
    if (slot_ == 0) reads_.drop_line();
  }

  Channel<ReadCommand>& commands_;
  Channel<Item>& items_;
  LineReads reads_;
  std::uint64_t next_line_ = 0;
  std::uint64_t lines_left_ = 0;
  std::uint64_t items_left_ = 0;
  std::size_t slot_ = 0;  ///< of the next item in its line
};

}  // namespace cbvh::rtl
