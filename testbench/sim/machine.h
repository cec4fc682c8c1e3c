// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "golden/input_error.h"
#include "rtl_model/kernel/clock.h"
#include "rtl_model/kernel/netlist.h"
#include "rtl_model/kernel/utilisation.h"
#include "testbench/progress.h"
#include "testbench/sim/port_stalls.h"
#include "testbench/sim/waveform.h"

namespace cbvh::testbench {

/// How a design is run, and who looks on.
struct MachineOptions {
  std::uint64_t watchdog_cycles = 100000;
  bool utilisation = true;
  bool progress = true;  ///< a bar on a terminal
  std::optional<WaveformRequest> waveform;
  std::optional<std::uint64_t> shuffle;  ///< seed of a random evaluation order, new every cycle
  std::optional<std::uint64_t> stalls;   ///< seed of random stalls at the memory's ports
};

struct MachineRun {
  std::uint64_t cycles = 0;
  double seconds = 0;  ///< of the host
  std::vector<rtl::ModuleUse> utilisation;
};

/// Cycles between two looks at whether anything moves, and at the progress.
constexpr std::uint64_t kWatchPeriod = 4096;

/// A simulation in which no channel moves any more. Its text names the modules that wait.
class Deadlock : public golden::InputError {
 public:
  Deadlock(std::uint64_t cycle, std::uint64_t idle_cycles, const std::vector<std::string>& waiting)
      : InputError("sim", fmt::format("deadlock in cycle {}: nothing has moved for {} cycles; {}", cycle, idle_cycles,
                                      fmt::join(waiting, "; "))) {}
};

/// Steps design, stalls and memory until `done()`, which is asked after every cycle. progress() counts items; it is
/// asked now and then. Throws Deadlock.
template <class Design, class Memory, class Done, class Count>
MachineRun run_machine(Design& design, PortStalls& stalls, Memory& memory, const MachineOptions& options,
                       std::uint64_t items, Done&& done, Count&& count) {
  const auto start = std::chrono::steady_clock::now();
  rtl::Netlist netlist;
  netlist.add(design);
  rtl::Clock clock(design, stalls, memory);
  std::optional<rtl::Utilisation> utilisation;
  if (options.utilisation) utilisation.emplace(netlist);
  std::optional<Waveform> waveform;
  if (options.waveform) waveform.emplace(*options.waveform, design);
  rtl::SplitMix64 order(options.shuffle.value_or(0));
  std::optional<Progress> progress;
  if (options.progress) progress.emplace("simulate", items);
  std::uint64_t transfers = 0;
  std::uint64_t moved_at = 0;
  std::uint64_t counted = 0;
  while (!done()) {
    options.shuffle ? clock.step_shuffled(order) : clock.step();
    if (utilisation) utilisation->observe();
    if (waveform) waveform->sample(clock.cycle());
    if (clock.cycle() % kWatchPeriod != 0) continue;
    const std::uint64_t now = netlist.transfers();
    if (now != transfers) moved_at = clock.cycle();
    transfers = now;
    if (clock.cycle() - moved_at >= options.watchdog_cycles)
      throw Deadlock(clock.cycle(), clock.cycle() - moved_at, netlist.waiting());
    const std::uint64_t done_items = count();
    if (progress) progress->step(done_items - counted);
    counted = done_items;
  }
  if (waveform) waveform->commit();
  MachineRun run;
  run.cycles = clock.cycle();
  run.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (utilisation) run.utilisation = utilisation->rows();
  return run;
}

}  // namespace cbvh::testbench
