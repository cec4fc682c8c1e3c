// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tuple>

#include "rtl_model/kernel/stall.h"
#include "rtl_model/memory/ideal_line_memory.h"
#include "tests/support/unit_run.h"

namespace cbvh::testing {

/// The ends of a port to memory: a module is joined to near(), the memory to far(). In between, requests and answers
/// are held back at random, in order.
class StallingPort {
 public:
  explicit StallingPort(const Disturbance& disturbance, std::uint64_t number = 0)
      : requests_stall_(pattern(disturbance.sink_stalls, disturbance.seed + 300 + 2 * number)),
        answers_stall_(pattern(disturbance.source_stalls, disturbance.seed + 301 + 2 * number)) {}

  rtl::LinePort near() { return {&near_requests_, &near_answers_}; }
  rtl::LinePort far() { return {&far_requests_, &far_answers_}; }

  void tick() {
    if (!requests_stall_.stalls() && near_requests_.can_pop() && far_requests_.can_push()) {
      far_requests_.push(near_requests_.pop());
    }
    if (!answers_stall_.stalls() && far_answers_.can_pop() && near_answers_.can_push()) {
      near_answers_.push(far_answers_.pop());
    }
  }
  void commit(rtl::CommitKey key) {
    near_requests_.commit(key);
    near_answers_.commit(key);
    far_requests_.commit(key);
    far_answers_.commit(key);
  }

 private:
  static rtl::StallPattern pattern(bool stalls, std::uint64_t seed) {
    return stalls ? rtl::StallPattern::bursts(seed) : rtl::StallPattern::never();
  }

  rtl::Channel<rtl::LineRequest> near_requests_, far_requests_;
  rtl::Channel<rtl::LineData> near_answers_, far_answers_;
  rtl::StallPattern requests_stall_;
  rtl::StallPattern answers_stall_;
};

/// Steps until done() or too many cycles; in the order of evaluation the disturbance asks for.
template <class Clock, class Done>
bool run_until(Clock& clock, const Disturbance& disturbance, std::uint64_t deadline, Done&& done) {
  rtl::SplitMix64 order(disturbance.seed);
  while (!done()) {
    if (clock.cycle() >= deadline) return false;
    if (disturbance.shuffled_order) {
      clock.step_shuffled(order);
    } else {
      clock.step();
    }
  }
  return true;
}

}  // namespace cbvh::testing
