// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_model/kernel/fifo.h"
#include "rtl_model/memory/line_port.h"

namespace cbvh::rtl {

/// The reads of one module at its port: in flight, or waiting here to be used. There are never more than there is room
/// for, so an answer is taken the moment it comes and the module never blocks its memory. A part of the module that has
/// it, so it has no clock of its own.
class LineReads {
 public:
  LineReads(LinePort port, std::size_t outstanding) : port_(port), lines_(outstanding) {}

  /// Call first in every tick.
  void take_answer() {
    if (in_flight_ == 0 || !port_.answers->can_pop()) return;
    lines_.push() = port_.answers->pop().words;
    --in_flight_;
  }

  /// At most one request a clock.
  bool can_request() const { return port_.requests->can_push() && in_flight_ < lines_.free(); }
  void request(LineAddress line) {
    LineRequest wanted;
    wanted.line = line;
    port_.requests->push(wanted);
    ++in_flight_;
  }

  /// The oldest line that is here. One use a clock: in hardware a read of a memory of lines.
  bool has_line() const { return !lines_.empty(); }
  const LineWords& line() const { return lines_.front(); }
  void drop_line() { lines_.pop(); }

  std::size_t pending() const { return in_flight_ + lines_.size(); }

 private:
  LinePort port_;
  Fifo<LineWords> lines_;
  std::size_t in_flight_ = 0;
};

}  // namespace cbvh::rtl
