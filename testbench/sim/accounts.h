// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "rtl_model/lbvh/pipeline_config.h"
#include "testbench/sim/machine.h"
#include "testbench/sim/sim_memory.h"
#include "testbench/sim/sim_result.h"

/// What every simulated machine's result is made of.
namespace cbvh::testbench {

/// A row of the traffic table. `accounted_bytes` is what the accesses must add up to when whole lines are counted.
inline void add_traffic(SimResult& result, const std::string& purpose, const PortAccesses& accesses,
                        std::uint64_t model_bytes, std::uint64_t accounted_bytes, const std::string& explanation) {
  const auto explained = static_cast<std::int64_t>(accounted_bytes) - static_cast<std::int64_t>(model_bytes);
  result.traffic.push_back(
      {purpose, accesses.reads, accesses.writes, model_bytes, explained, explained != 0 ? explanation : ""});
}
/// An array in whole lines.
constexpr std::uint64_t whole_lines(std::uint64_t bytes) { return (bytes + 63) / 64 * 64; }

/// Accesses by module.
using ModuleAccesses = std::map<std::string, PortAccesses>;
inline ModuleAccesses module_accesses(const std::vector<rtl::NamedPort>& ports, const SimMemory& memory) {
  ModuleAccesses accesses;
  for (std::size_t i = 0; i < ports.size(); ++i) accesses[ports[i].module] = memory.port_accesses(i);
  return accesses;
}
inline std::vector<rtl::LinePort> unnamed(const std::vector<rtl::NamedPort>& ports) {
  std::vector<rtl::LinePort> result;
  result.reserve(ports.size());
  for (const rtl::NamedPort& port : ports) result.push_back(port.port);
  return result;
}

/// What every machine's run gives.
inline void add_run(SimResult& result, const MachineRun& run, const SimConfig& config, const SimMemory& memory) {
  result.cycles = run.cycles;
  result.clock_mhz = config.dram.core_clock_mhz;
  result.bound_cycles = memory.bound_cycles();
  result.memory = memory.statistics();
  result.utilisation = run.utilisation;
  result.seconds = run.seconds;
}

}  // namespace cbvh::testbench
