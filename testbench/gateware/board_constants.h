// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace cbvh::testbench {

/// fpga/gateware/engine/cbvh_board.vh: numbers of the board link as fpga/host/ has them, and for every unit, chosen by
/// a macro CBVH_UNIT_x, what the frame engine says and must know of it.
std::string board_constants();

}  // namespace cbvh::testbench
