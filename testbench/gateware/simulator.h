// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "testbench/backend/run_options.h"
#include "vectors/vector_set.h"

namespace cbvh::testbench {

/// Empty, or what is missing to simulate Verilog.
std::string why_no_simulator();

/// The folder of the twins: $CBVH_GATEWARE, or one with the files of fpga/gateware/ that lasts as long as the process.
std::string twin_folder();

/// Whether the unit has a memory port, and so runs with its memory inside a module of fpga/gateware/harness/.
bool has_harness(const vectors::UnitDescription& unit);

/// That module.
std::string harness_name(const vectors::UnitDescription& unit);

/// Whether fpga/gateware/ has a twin of the unit. Where $CBVH_GATEWARE names a folder, its files are used instead.
bool has_twin(const vectors::UnitDescription& unit);

/// Runs the cases of a set through the twin of its unit between two skid buffers, under Icarus Verilog: those of a unit
/// without state as one stream, the others one by one from reset. Gives the bench's trace. Compiled models are kept for
/// the life of the process. Throws InputError when the Verilog does not compile.
std::string simulate_twin(const vectors::VectorSet& set, const RunOptions& options);

}  // namespace cbvh::testbench
