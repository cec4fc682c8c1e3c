// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "rtl_model/memory/dram.h"
#include "rtl_model/memory/ideal_line_memory.h"
#include "testbench/sim/sim_config.h"
#include "testbench/sim/sim_result.h"
#include "vectors/format/output.h"

namespace cbvh::testbench {

/// 64-byte accesses that a port asked for.
struct PortAccesses {
  std::uint64_t reads = 0;
  std::uint64_t writes = 0;
};

/// The memory that the configuration asks for, and what goes through each of its ports.
class SimMemory {
 public:
  /// `trace_path`: the accesses of a DRAM are written there, by finish(); empty: nowhere.
  SimMemory(const SimConfig& config, const std::vector<rtl::LinePort>& ports, const std::string& trace_path);

  void tick() { dram_ ? dram_->tick() : ideal_->tick(); }
  void commit(rtl::CommitKey key) { dram_ ? dram_->commit(key) : ideal_->commit(key); }

  /// Whether everything is on the pins.
  bool idle() const { return !dram_ || dram_->idle(); }
  rtl::LineStore& store() { return dram_ ? dram_->store : ideal_->store; }
  const rtl::LineStore& store() const { return dram_ ? dram_->store : ideal_->store; }
  PortAccesses port_accesses(std::size_t port) const;
  double bound_cycles() const { return dram_ ? static_cast<double>(dram_->bound_cycles()) : 0; }
  std::vector<MemoryStatistic> statistics() const;
  /// Completes the trace. Throws InputError when an access was beyond the capacity.
  void finish();

 private:
  std::optional<rtl::Dram> dram_;
  std::optional<rtl::IdealLineMemory> ideal_;
  std::unique_ptr<vectors::Output> trace_;
};

}  // namespace cbvh::testbench
