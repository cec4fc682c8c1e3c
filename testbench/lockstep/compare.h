// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "testbench/lockstep/twin.h"

namespace cbvh::testbench {

/// How far a twin was like its C++ module under one pattern of stalls.
struct LockstepResult {
  std::string twin;
  Stalls stalls = Stalls::none;
  std::uint64_t cycles = 0;   ///< compared
  std::uint64_t signals = 0;  ///< compared in all of them
  std::uint64_t moves = 0;    ///< items pushed into and popped from channels by the C++ module and its surroundings
  std::string difference;     ///< the first: unit, where, signal, both values. Empty if there was none.

  /// Zero checks is a failure.
  bool pass() const { return difference.empty() && cycles > 0 && moves > 0; }
};

/// Compares for at least so many cycles under each of the patterns, shared by the twin's parameters, from this seed on;
/// a result for each pattern. Throws InputError when the Verilog does not compile, std::runtime_error when a channel
/// stood still.
std::vector<LockstepResult> compare_lockstep(const LockstepTwin& twin, const std::vector<Stalls>& patterns,
                                             std::uint64_t cycles, std::uint64_t seed);

}  // namespace cbvh::testbench
