// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "rtl_model/datapath/payloads.h"
#include "rtl_model/kernel/channel.h"
#include "rtl_model/kernel/fifo.h"
#include "rtl_model/kernel/random.h"

namespace cbvh::rtl {

/// An ideal memory of node pairs: takes a request a clock, in order, and answers a read `latency` clocks after taking
/// it, plus a random delay of up to `jitter`. It grows to the highest line written. Reading what was never written
/// gives zeros.
template <int N>
class FixedLatencyMemory {
 public:
  FixedLatencyMemory(Channel<MemoryRequest<N>>& requests, Channel<MemoryLine<N>>& lines, unsigned latency = 4,
                     unsigned jitter = 0, std::uint64_t seed = 0)
      : requests_(requests), lines_(lines), latency_(latency), jitter_(jitter), random_(seed) {}

  void tick() {
    ++cycle_;
    if (!answers_.empty() && answers_.front().ready_cycle <= cycle_ && lines_.can_push()) {
      lines_.push(answers_.front().line);
      answers_.pop();
    }
    if (!requests_.can_pop() || answers_.free() == 0) return;
    const MemoryRequest<N>& request = requests_.pop();
    if (request.write) {
      write(request);
      ++writes;
    } else {
      auto& answer = answers_.push();
      answer.ready_cycle = cycle_ + latency_ - 1 + (jitter_ == 0 ? 0 : random_.below(jitter_ + 1));
      answer.line = read(request.line.value());
      ++reads;
    }
  }
  void commit(CommitKey) {}

  std::vector<NodePair<N>> pairs;  ///< the content, by emission index
  std::uint64_t reads = 0;         ///< 64-byte accesses
  std::uint64_t writes = 0;

 private:
  struct Answer {
    std::uint64_t ready_cycle = 0;
    MemoryLine<N> line;
  };

  void write(const MemoryRequest<N>& request) {
    const std::size_t first = request.line.value() * kPairsPerLine;
    if (pairs.size() < first + kPairsPerLine) pairs.resize(first + kPairsPerLine);
    for (std::size_t i = 0; i < kPairsPerLine; ++i) {
      if (request.mask.value() >> i & 1u) pairs[first + i] = request.pairs[i];
    }
  }
  MemoryLine<N> read(std::size_t line) const {
    MemoryLine<N> result;
    const std::size_t first = line * kPairsPerLine;
    for (std::size_t i = 0; i < kPairsPerLine && first + i < pairs.size(); ++i) result.pairs[i] = pairs[first + i];
    return result;
  }

  Channel<MemoryRequest<N>>& requests_;
  Channel<MemoryLine<N>>& lines_;
  Fifo<Answer> answers_{16};
  const unsigned latency_;
  const unsigned jitter_;
  SplitMix64 random_;
  std::uint64_t cycle_ = 0;
};

}  // namespace cbvh::rtl
