// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "rtl_model/memory/ideal_line_memory.h"
#include "testbench/backend/run_options.h"
#include "testbench/rtl/memory_port.h"

/// The memory behind ports of 64-byte lines, and who watches it.
namespace cbvh::testbench {

/// Lines that a unit under test may use: vectors stay far below.
constexpr std::uint64_t kMemoryLines = 1 << 16;

inline rtl::IdealLineMemory make_line_memory(const std::vector<rtl::LinePort>& ports, const RunOptions& options,
                                             std::uint64_t number) {
  const bool jitters = options.stalls == Stalls::sink || options.stalls == Stalls::both;
  return rtl::IdealLineMemory(ports, kMemoryLines, options.memory_latency, jitters ? kMemoryJitter : 0,
                              options.stall_seed + number);
}

/// Notes the writes that the memory takes at one port.
class LineWriteMonitor {
 public:
  explicit LineWriteMonitor(const rtl::Channel<rtl::LineRequest>& channel) : channel_(channel) {}

  void commit(rtl::CommitKey) {
    if (channel_.pops() != taken_ && bool(channel_.last_popped().write)) writes.push_back(channel_.last_popped());
    taken_ = channel_.pops();
  }

  std::vector<rtl::LineRequest> writes;

 private:
  const rtl::Channel<rtl::LineRequest>& channel_;
  std::uint64_t taken_ = 0;
};

}  // namespace cbvh::testbench
