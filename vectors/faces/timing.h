// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "vectors/faces/collector.h"

/// In which cycle an undisturbed unit responds: what the modules' descriptions promise, as recurrences over whole jobs.
/// The source always offers, the sink always takes, and memory answers after kMemoryLatency cycles.
namespace cbvh::vectors {

constexpr std::uint32_t kMemoryLatency = 4;

/// Both collectors take one job a cycle, and give one final pair a cycle from a queue that jobs wait for when it could
/// overflow.
struct CollectorTiming {
  int levels;  ///< D
  bool lazy;   ///< one compressor, and a cycle for each pair that is re-encoded on chip
};

/// The cycle of each final pair, counted from the acceptance of the first job.
std::vector<std::uint32_t> collector_cycles(std::span<const rtl::StreamJob> jobs, std::span<const FinalAnswer> finals,
                                            const CollectorTiming& timing, int bits);

/// For each job of a stream the pairs up to `levels - 1` levels below its own that its arrival invalidates: what a lazy
/// collector re-encodes on chip.
std::vector<std::uint32_t> on_chip_repairs(std::span<const rtl::StreamJob> jobs, int levels, int bits);

/// The backtrack unit reads, re-encodes and writes one pair after the other: cycles of one such step, from one read to
/// the next.
constexpr std::uint32_t kRepairCycles = kMemoryLatency + 2;

/// The stream compressor reports two cycles after it got a tree's last final pair, if nothing is being repaired.
constexpr std::uint32_t kReportCycles = 2;

}  // namespace cbvh::vectors
