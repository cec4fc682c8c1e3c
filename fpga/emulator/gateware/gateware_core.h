// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>

#include "fpga/emulator/core.h"
#include "fpga/emulator/gateware/simulation.h"

namespace cbvh::emulator {

/// The Verilog frame engine with one unit inside, under Icarus Verilog: what a board of fpga/boards/ would do. When the
/// simulation ends or does not answer for a minute, the core is silent for good.
class GatewareCore final : public Core {
 public:
  /// Throws as Simulation does.
  explicit GatewareCore(const SimulationOptions& options = {}) : simulation_(options) {}

  void receive(std::span<const std::uint8_t> bytes) override;
  std::vector<std::uint8_t> send(std::size_t most) override;
  void reset() override;

 private:
  void advance();

  Simulation simulation_;
  std::deque<std::uint8_t> in_;  ///< not given to the simulation yet
  std::deque<std::uint8_t> out_;
  bool queued_ = false;  ///< the engine has bytes before it
  bool busy_ = false;
  bool ended_ = false;
};

}  // namespace cbvh::emulator
