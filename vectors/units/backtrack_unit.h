// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "vectors/faces/backtrack.h"
#include "vectors/faces/timing.h"
#include "vectors/generate/backtrack_steps.h"
#include "vectors/unit.h"

namespace cbvh::vectors {

template <int N>
BacktrackStep<N> to_wires(const PlainBacktrackStep& step) {
  BacktrackStep<N> wires;
  wires.repair = rtl::UInt<1>(step.repair);
  if (step.repair) {
    wires.job = {rtl::Pointer(step.index), to_wires(step.before), to_wires(step.after), step.registers};
  } else {
    wires.index = rtl::Pointer(step.index);
    wires.pair = to_wires<N>(step.pair);
  }
  return wires;
}

/// Repairs pairs in memory whose context turned out to be wrong. An episode fills memory and gives jobs; the events are
/// the pairs written, in order, and after each job their number.
template <int N>
struct BacktrackUnit {
  using Stimulus = BacktrackStep<N>;
  using Response = BacktrackEvent<N>;
  static constexpr std::string_view kName = "backtrack_unit";
  static constexpr std::string_view kSummary =
      "re-encodes pairs in memory for a coarser grid, and what that changes below";
  static constexpr std::string_view kLatencyText = "6 a repair, then 1";
  static constexpr bool kStateful = true;
  static constexpr bool kTreelet = false;
  static constexpr const auto& kClasses = kBacktrackClasses;

  static std::vector<Stimulus> generate(std::size_t case_class, Random& random, const Parameters&) {
    std::vector<Stimulus> stimuli;
    for (const PlainBacktrackStep& step : make_backtrack_steps(case_class, random, N)) {
      stimuli.push_back(to_wires<N>(step));
    }
    return stimuli;
  }

  static std::vector<Expected<Response>> respond(std::span<const Stimulus> steps, const Parameters&) {
    std::vector<Expected<Response>> events;
    BacktrackMemory memory(N);
    std::uint32_t cycle = 0;
    for (const Stimulus& step : steps) {
      if (!step.repair) {
        memory.write(static_cast<std::uint32_t>(step.index.raw()), from_wires(step.pair));
        continue;
      }
      const auto repaired = memory.repair(static_cast<std::uint32_t>(step.job.pointer.raw()),
                                          from_wires(step.job.before), from_wires(step.job.after), step.job.registers);
      for (const RepairedPair& pair : repaired) {
        events.push_back(
            {{rtl::UInt<1>(0), rtl::Pointer(pair.index), to_wires<N>(pair.pair), {}}, cycle += kRepairCycles});
      }
      events.push_back({{rtl::UInt<1>(1), {}, {}, rtl::UInt<32>(repaired.size())}, ++cycle});
    }
    return events;
  }
};

}  // namespace cbvh::vectors
