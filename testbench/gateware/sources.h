// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>
#include <vector>

namespace cbvh::testbench {

/// A Verilog file, compiled in so that the command runs from anywhere.
struct GatewareSource {
  std::string_view name;   ///< the file's
  std::string_view bytes;  ///< its content
};
/// fpga/gateware/: the twins.
std::vector<GatewareSource> gateware_sources();
/// fpga/gateware/bench/ and harness/: what runs them.
std::vector<GatewareSource> gateware_benches();
/// fpga/gateware/engine/ and fpga/boards/common/: the board's side of the link.
std::vector<GatewareSource> gateware_engine();

}  // namespace cbvh::testbench
