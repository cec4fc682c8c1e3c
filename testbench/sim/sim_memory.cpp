// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/sim/sim_memory.h"

#include "golden/input_error.h"

namespace cbvh::testbench {

SimMemory::SimMemory(const SimConfig& config, const std::vector<rtl::LinePort>& ports, const std::string& trace_path) {
  if (config.memory == MemoryKind::ideal) {
    ideal_.emplace(ports, config.dram.capacity_bytes / rtl::kBytesPerLine, config.ideal_latency, config.dram.jitter,
                   config.dram.seed);
    return;
  }
  dram_.emplace(config.dram, ports);
  if (trace_path.empty()) return;
  trace_.reset(new vectors::Output(vectors::Output::to_file(trace_path)));
  dram_->hooks.on_access = [this](const rtl::DramAccess& access) {
    trace_->append(rtl::dram_trace_line(access));
    trace_->append("\n");
    trace_->flush_when_large();
  };
}

PortAccesses SimMemory::port_accesses(std::size_t port) const {
  if (dram_) return {dram_->port_counts(port).reads, dram_->port_counts(port).writes};
  return {ideal_->port_counts(port).reads, ideal_->port_counts(port).writes};
}

std::vector<MemoryStatistic> SimMemory::statistics() const {
  std::vector<MemoryStatistic> rows;
  if (!dram_) {
    return {{"reads", "lines", "64-byte reads", static_cast<double>(ideal_->reads)},
            {"writes", "lines", "64-byte writes", static_cast<double>(ideal_->writes)}};
  }
  for (const rtl::DramStatistic& row : dram_->statistics())
    rows.push_back({row.name, row.unit, row.description, row.value});
  return rows;
}

void SimMemory::finish() {
  if (const auto line = store().out_of_range())
    throw golden::InputError("sim",
                             fmt::format("access to line {}, the memory has {}", *line, store().capacity_lines()));
  if (trace_) trace_->commit();
}

}  // namespace cbvh::testbench
