// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace cbvh::testbench {

/// Which ends of a unit hold back, in bursts of random length. `both` stalls are independent.
enum class Stalls : std::uint8_t { none, source, sink, both };

/// Throws InputError naming the modes.
Stalls parse_stalls(const std::string& text);
std::string to_string(Stalls stalls);
std::vector<std::string> stall_names();

/// How a backend runs cases. Without stalls every response has its stated latency; with them only its bits are fixed.
struct RunOptions {
  Stalls stalls = Stalls::none;
  std::uint64_t stall_seed = 1;          ///< mixed with a case's number
  std::optional<std::uint64_t> shuffle;  ///< seed: modules are evaluated in a new random order every cycle
  unsigned memory_latency = 4;           ///< cycles, of units with a memory port
  std::uint64_t hang_cycles = 20000;     ///< without any progress
  std::uint64_t drain_cycles = 64;       ///< after the last wanted response, in which a surplus one would be seen
};

/// "none", "both shuffled", ...: a set's mode in reports.
std::string mode_name(const RunOptions& options);

}  // namespace cbvh::testbench
