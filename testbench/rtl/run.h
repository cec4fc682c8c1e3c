// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "rtl_model/kernel/clock.h"
#include "testbench/backend/run_options.h"

namespace cbvh::testbench {

/// Steps a clock in the evaluation order asked for, and gives up when nothing moves.
template <class Clock>
class Runner {
 public:
  Runner(Clock& clock, const RunOptions& options)
      : clock_(clock),
        random_(options.shuffle.value_or(0)),
        shuffled_(options.shuffle),
        hang_cycles_(options.hang_cycles),
        drain_cycles_(options.drain_cycles) {}

  void step() { shuffled_ ? clock_.step_shuffled(random_) : clock_.step(); }

  /// Steps until done() says so; false when progress() has not changed for long enough to call it a hang.
  template <class Done, class Progress>
  bool run_until(Done&& done, Progress&& progress) {
    auto last = progress();
    std::uint64_t idle = 0;
    while (!done()) {
      step();
      const auto now = progress();
      idle = now == last ? idle + 1 : 0;
      last = now;
      if (idle >= hang_cycles_) return false;
    }
    return true;
  }
  void drain() {
    for (std::uint64_t i = 0; i < drain_cycles_; ++i) step();
  }

 private:
  Clock& clock_;
  rtl::SplitMix64 random_;
  bool shuffled_;
  std::uint64_t hang_cycles_;
  std::uint64_t drain_cycles_;
};

}  // namespace cbvh::testbench
