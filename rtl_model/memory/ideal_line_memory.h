// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "rtl_model/kernel/channel.h"
#include "rtl_model/kernel/fifo.h"
#include "rtl_model/kernel/random.h"
#include "rtl_model/kernel/stall.h"
#include "rtl_model/memory/line_store.h"

namespace cbvh::rtl {

/// A memory that takes a request a clock at every port and answers `latency` clocks later. With a `jitter` answers are
/// late by up to so many clocks more, at random, and ports take no requests for a while: for tests of modules, and for
/// asking what a design would do without DRAM.
class IdealLineMemory {
 public:
  IdealLineMemory(const std::vector<LinePort>& ports, std::uint64_t capacity_lines, unsigned latency = 4,
                  unsigned jitter = 0, std::uint64_t seed = 0)
      : store(capacity_lines), latency_(latency), jitter_(jitter), random_(seed) {
    for (const LinePort& port : ports) {
      ports_.push_back({port,
                        Fifo<Answer>(kOutstanding),
                        jitter == 0 ? StallPattern::never() : StallPattern::bursts(seed + ports_.size()),
                        {}});
    }
  }

  void tick() {
    ++cycle_;
    for (auto& [port, answers, stalls, counts] : ports_) {
      if (!answers.empty() && answers.front().ready_cycle <= cycle_ && port.answers->can_push()) {
        port.answers->push(answers.front().data);
        answers.pop();
      }
      if (stalls.stalls() || !port.requests->can_pop() || answers.free() == 0) continue;
      const LineRequest& request = port.requests->pop();
      ++(request.write ? counts.writes : counts.reads);
      take(request, answers);
    }
  }
  void commit(CommitKey) {}

  /// 64-byte accesses of one port.
  struct Counts {
    std::uint64_t reads = 0;
    std::uint64_t writes = 0;
  };
  const Counts& port_counts(std::size_t port) const { return ports_[port].counts; }

  LineStore store;
  std::uint64_t reads = 0;  ///< 64-byte accesses
  std::uint64_t writes = 0;

 private:
  static constexpr std::size_t kOutstanding = 64;
  struct Answer {
    std::uint64_t ready_cycle = 0;
    LineData data;
  };
  struct Port {
    LinePort port;
    Fifo<Answer> answers;
    StallPattern stalls;
    Counts counts;
  };

  void take(const LineRequest& request, Fifo<Answer>& answers) {
    ++(request.write ? writes : reads);
    if (request.write) store.write(request);
    if (request.write && !request.acknowledge) return;
    Answer& answer = answers.push();
    answer.ready_cycle = cycle_ + latency_ - 1 + (jitter_ == 0 ? 0 : random_.below(jitter_ + 1));
    answer.data = request.write ? LineData() : store.read(request.line);
  }

  std::vector<Port> ports_;
  const unsigned latency_;
  const unsigned jitter_;
  SplitMix64 random_;
  std::uint64_t cycle_ = 0;
};

}  // namespace cbvh::rtl
