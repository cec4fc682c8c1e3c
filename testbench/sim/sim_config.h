// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "golden/quantize/codes.h"
#include "golden/quantize/grid.h"
#include "rtl_model/memory/dram_config.h"
#include "testbench/rtl/stream_run.h"

namespace cbvh::testbench {

/// What the pipeline writes. Paper table 2.
enum class PipelineOutput : std::uint8_t {
  floats,           ///< 64-byte float pairs
  floats_top_down,  ///< float pairs, then compressed by a top-down pass over them
  streaming         ///< compressed on the way out
};

enum class MemoryKind : std::uint8_t { dram, ideal };

/// Everything that can be chosen of the simulated machine. The defaults are the paper's (section 5.3).
struct SimConfig {
  PipelineOutput output = PipelineOutput::streaming;
  golden::Code code = golden::Code::modulo;
  golden::ScaleRule scale_rule = golden::ScaleRule::equation2;
  Collector collector = Collector::full;
  unsigned treelet = 4;
  unsigned bits = 6;
  std::optional<int> min_scale;  ///< empty: the scene's exactness limit

  unsigned scratchpad_bytes = 262144;
  unsigned buffer_records = 8;
  unsigned refill_lines = 16;
  unsigned reader_outstanding = 32;
  unsigned merger_outstanding = 64;
  unsigned run_skew_lines = 0;
  unsigned combining_lines = 128;
  unsigned gather_lines = 4096;
  unsigned gather_outstanding = 64;
  unsigned gather_queue = 256;
  unsigned max_triangles = 1U << 27;

  MemoryKind memory = MemoryKind::dram;
  unsigned ideal_latency = 40;
  rtl::DramConfig dram;
  unsigned watchdog_cycles = 100000;
};

/// One entry of the table of configuration values: how it is called, said, and what it means.
struct SimParameter {
  std::string name;
  std::string unit;
  std::string description;
  std::function<std::string(const SimConfig&)> get;
  std::function<void(SimConfig&, const std::string& value)> set;  ///< throws InputError
};
const std::vector<SimParameter>& sim_parameters();

/// Sets "name=value". Throws InputError with `place`.
void set_sim_parameter(SimConfig& config, const std::string& assignment, const std::string& place);

/// A named configuration (the columns of the paper's table 2), or a JSON file of names and values. Throws InputError.
SimConfig load_sim_config(const std::string& name_or_file);
std::vector<std::string> sim_config_names();

/// Throws InputError naming the first value that cannot be, what was found and what is wanted.
void check_sim_config(const SimConfig& config);

}  // namespace cbvh::testbench
