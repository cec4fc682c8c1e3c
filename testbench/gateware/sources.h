// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>
#include <vector>

namespace cbvh::testbench {

/// A file of fpga/gateware/ or of its bench/, compiled in so that the command runs from anywhere.
struct GatewareSource {
  std::string_view name;   ///< the file's
  std::string_view bytes;  ///< its content
};
std::vector<GatewareSource> gateware_sources();

}  // namespace cbvh::testbench
