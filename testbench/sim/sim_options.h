// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "testbench/command.h"
#include "testbench/output.h"
#include "testbench/sim/simulate.h"

namespace cbvh::testbench {

/// The options that the commands which simulate a machine have in common.
class SimOptions {
 public:
  void add_to(const Command& command);
  /// Throws InputError.
  SimRequest request() const;
  /// With --list-config: prints the values, and says so.
  bool lists_config(const SimConfig& config, const Output& output) const;

 private:
  std::string config_ = "streaming-modulo";
  std::vector<std::string> assignments_;
  bool list_ = false;
  bool no_utilisation_ = false;
  std::string waveform_;
  std::string scope_;
  std::string cycles_;
  std::string trace_;
  std::optional<std::uint64_t> shuffle_;
  std::optional<std::uint64_t> stalls_;
};

Json to_json(const SimConfig& config);

}  // namespace cbvh::testbench
