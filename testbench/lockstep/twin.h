// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "testbench/backend/run_options.h"
#include "testbench/lockstep/episode.h"
#include "vectors/episode.h"

namespace cbvh::testbench {

/// The N at which twins are compared that depend on it: the ends and the default.
inline const std::vector<vectors::Parameters> kLockstepBits = {{2, 1}, {6, 1}, {8, 1}};

/// Calls f(std::integral_constant<int, N>) for one of those N.
template <class F>
auto with_lockstep_bits(int bits, F&& f) {
  if (bits == 2) return f(std::integral_constant<int, 2>());
  if (bits == 8) return f(std::integral_constant<int, 8>());
  return f(std::integral_constant<int, 6>());
}

/// A module of fpga/gateware/ and the C++ module it is the twin of.
struct LockstepTwin {
  std::string_view name;                                          ///< of the Verilog module
  std::vector<vectors::Parameters> parameters;                    ///< to compare it with
  std::string (*verilog)(const vectors::Parameters& parameters);  ///< the module's parameter list, "#(.N(6))"
  /// Episodes of some thousand clocks in all, each from reset, that depend on the seed and the options alone.
  std::vector<Episode> (*record)(const vectors::Parameters& parameters, const RunOptions& options, std::uint64_t seed);
};

/// Describes one twin. lockstep/twins/x.cpp defines x_twin and needs no entry anywhere.
using DescribeTwin = LockstepTwin();
std::vector<DescribeTwin*> all_twin_descriptions();

/// In the order of their names.
std::vector<LockstepTwin> all_lockstep_twins();

}  // namespace cbvh::testbench
