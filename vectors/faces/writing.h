// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "vectors/faces/timing.h"
#include "vectors/lbvh_payloads.h"
#include "vectors/unit.h"

/// Lines and reports of a unit that writes a stream to memory and takes an item a cycle.
namespace cbvh::vectors {

class WriteEvents {
 public:
  explicit WriteEvents(std::uint64_t base) : base_(base) {}

  /// An item that fills no line, or the last one of a line. Memory takes the line a cycle after the unit has taken the
  /// item. Behind the last item of all, memory acknowledges the line, the unit sends its report, and begins again.
  void pass() {
    ++items_;
    ++cycle_;
  }
  void write(const rtl::LineWords& words, std::uint64_t mask, bool last) {
    pass();
    WriteEvent line;
    line.request = {rtl::UInt<1>(1), rtl::UInt<1>(last), rtl::LineAddress(base_ + lines_++),
                    rtl::UInt<rtl::kWordsPerLine>(mask), words};
    events.push_back({line, cycle_});
    if (!last) return;
    cycle_ += kMemoryLatency + 1;
    WriteEvent end;
    end.is_report = rtl::UInt<1>(1);
    end.report = {rtl::UInt<rtl::kPointerBits + 1>(items_), rtl::UInt<32>(lines_)};
    events.push_back({end, cycle_});
    items_ = lines_ = 0;
  }

  std::vector<Expected<WriteEvent>> events;

 private:
  std::uint64_t base_;
  std::uint64_t items_ = 0;
  std::uint64_t lines_ = 0;
  std::uint32_t cycle_ = 0;  ///< in which the next item is taken, from the first one on
};

}  // namespace cbvh::vectors
