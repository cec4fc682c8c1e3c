// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace cbvh::testbench {

/// fpga/gateware/cbvh_constants.vh: widths, depths, status codes, and where each field of a payload lies in its packed
/// bits, in terms of the parameter N. The C++ model is the one source of them.
std::string gateware_constants();

}  // namespace cbvh::testbench
