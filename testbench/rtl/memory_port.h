// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "rtl_model/kernel/channel.h"
#include "rtl_model/memory/fixed_latency_memory.h"
#include "testbench/backend/run_options.h"

/// The memory behind a unit's port, and who watches it.
namespace cbvh::testbench {

/// Cycles by which a read may be late, at random, when sinks stall: memory is one of the ends.
constexpr unsigned kMemoryJitter = 13;

constexpr std::uint64_t memory_seed(const RunOptions& options, std::uint64_t number) {
  return options.stall_seed + number;
}

template <int N>
rtl::FixedLatencyMemory<N> make_memory(rtl::Channel<rtl::MemoryRequest<N>>& requests,
                                       rtl::Channel<rtl::MemoryLine<N>>& lines, const RunOptions& options,
                                       std::uint64_t number) {
  const bool jitters = options.stalls == Stalls::sink || options.stalls == Stalls::both;
  return rtl::FixedLatencyMemory<N>(requests, lines, options.memory_latency, jitters ? kMemoryJitter : 0,
                                    memory_seed(options, number));
}

/// Notes the writes that the memory takes.
template <int N>
class WriteMonitor {
 public:
  struct Write {
    std::uint64_t cycle;
    rtl::MemoryRequest<N> request;
  };

  explicit WriteMonitor(const rtl::Channel<rtl::MemoryRequest<N>>& channel, bool enabled = true)
      : channel_(channel), enabled_(enabled) {}

  void tick() { next_ = channel_.can_pop() ? &channel_.front() : nullptr; }
  void commit(rtl::CommitKey) {
    if (channel_.pops() != taken_ && enabled_ && bool(next_->write)) writes.push_back({cycle_, *next_});
    taken_ = channel_.pops();
    ++cycle_;
  }

  std::vector<Write> writes;

 private:
  const rtl::Channel<rtl::MemoryRequest<N>>& channel_;
  bool enabled_;
  const rtl::MemoryRequest<N>* next_ =
      nullptr;  ///< what a pop in this cycle would take; it stays in place until a push
  std::uint64_t taken_ = 0;
  std::uint64_t cycle_ = 0;
};

}  // namespace cbvh::testbench
