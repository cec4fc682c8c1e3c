// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "testbench/gateware/process.h"

namespace cbvh::emulator {

/// What is simulated, and how large it is.
struct SimulationOptions {
  std::string unit = "axis_compressor";
  int bits = 6;
  int treelet = 1;                           ///< D
  int buffers = 2;                           ///< batch buffers, 1 or 2
  int buffer_bits = 12;                      ///< 2^buffer_bits bytes each
  int result_bits = 12;                      ///< the buffer of results has 2^result_bits bytes
  bool pins = false;                         ///< behind the serial line of fpga/boards/common/, bit by bit
  std::optional<std::uint32_t> stalls = {};  ///< seed: both streams are held back at random
};

/// fpga/gateware/bench/engine_bench.v under Icarus Verilog, in a process of its own. One request is under way at a
/// time, and its bytes fit what the system keeps between two processes, so that neither waits for the other in a ring.
class Simulation {
 public:
  struct Answer {
    std::vector<std::uint8_t> bytes;  ///< from the board
    std::size_t left = 0;             ///< bytes that the engine has not taken yet; they stay queued
    bool busy = false;                ///< it would go on
  };
  static constexpr std::size_t kMostBytes = 4096;

  /// Compiles the Verilog, that of $CBVH_GATEWARE where it has a file, and starts it. Throws InputError when it does
  /// not compile, Unavailable when there is no Icarus, or no twin of the unit.
  explicit Simulation(const SimulationOptions& options);
  ~Simulation();
  Simulation(const Simulation&) = delete;
  Simulation& operator=(const Simulation&) = delete;

  /// Queues at most kMostBytes, and runs until all have been taken and nothing is left to do, at most so many clocks.
  /// Nothing once the process has ended or does not answer.
  std::optional<Answer> run(std::span<const std::uint8_t> bytes, unsigned clocks);
  /// Power-on. False like run.
  bool restart();

 private:
  std::optional<Answer> request(const std::string& text);
  bool write_all(const std::string& text);
  std::optional<std::string> read_answer();
  void start(const std::vector<std::string>& command);
  void stop();

  testbench::TemporaryFolder folder_;
  int socket_ = -1;
  int child_ = -1;
  std::string read_;  ///< and not looked at yet
};

}  // namespace cbvh::emulator
