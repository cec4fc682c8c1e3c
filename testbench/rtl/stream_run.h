// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "rtl_model/datapath/payloads.h"
#include "testbench/backend/run_options.h"

namespace cbvh::testbench {

/// Which treelet collector the stream compressor is built with: both write the same bits.
enum class Collector : std::uint8_t { full, lazy };

/// What a stream compressor did, seen from its ports.
template <int N>
struct StreamTrace {
  struct Write {
    std::uint64_t cycle;  ///< in which the memory took it
    rtl::MemoryRequest<N> request;
  };
  struct Report {
    std::uint64_t sent;  ///< cycle in which the unit sent it: all of its tree's writes are taken by the next cycle
    std::uint64_t seen;  ///< cycle in which the sink took it
    rtl::StreamReport report;
  };
  std::vector<Write> writes;  ///< when asked for
  std::vector<Report> reports;
  std::vector<rtl::NodePair<N>> memory;  ///< by emission index, at the end
  std::uint64_t started = 0;             ///< cycle in which the first job was taken
  std::uint64_t cycles = 0;
  bool hung = false;
};

/// Sends jobs through a stream compressor with D = `levels` and a memory, until as many reports as trees are back.
template <int N>
StreamTrace<N> run_stream(Collector collector, int levels, std::span<const rtl::StreamJob> jobs,
                          const RunOptions& options, std::uint64_t number, bool log_writes);

}  // namespace cbvh::testbench
