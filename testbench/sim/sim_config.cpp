// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/sim/sim_config.h"

#include <fmt/format.h>

#include <bit>

#include "golden/input_error.h"
#include "golden/tree/node_pair_format.h"
#include "testbench/output.h"

namespace cbvh::testbench {

namespace {

struct NamedConfig {
  const char* name;
  PipelineOutput output;
  golden::Code code;
  unsigned treelet;
};
constexpr NamedConfig kNamedConfigs[] = {
    {"float", PipelineOutput::floats, golden::Code::relative, 1},
    {"float-top-down", PipelineOutput::floats_top_down, golden::Code::relative, 1},
    {"streaming-relative", PipelineOutput::streaming, golden::Code::relative, 1},
    {"streaming-modulo", PipelineOutput::streaming, golden::Code::modulo, 4},
};

void check_range(const char* field, unsigned found, unsigned low, unsigned high) {
  if (found < low || found > high)
    throw golden::InputError(field, fmt::format("found {}, want {}..{}", found, low, high));
}

void check_power_of_two(const char* field, unsigned found) {
  if (!std::has_single_bit(found)) throw golden::InputError(field, fmt::format("found {}, want a power of two", found));
}

}  // namespace

std::vector<std::string> sim_config_names() {
  std::vector<std::string> names;
  for (const NamedConfig& named : kNamedConfigs) names.emplace_back(named.name);
  return names;
}

void set_sim_parameter(SimConfig& config, const std::string& assignment, const std::string& place) {
  const std::size_t equals = assignment.find('=');
  if (equals == std::string::npos)
    throw golden::InputError(place, fmt::format("found '{}', want NAME=VALUE", assignment));
  const std::string name = assignment.substr(0, equals);
  for (const SimParameter& parameter : sim_parameters()) {
    if (parameter.name != name) continue;
    try {
      parameter.set(config, assignment.substr(equals + 1));
    } catch (const golden::InputError& error) {
      throw golden::InputError(place, error.what());
    }
    return;
  }
  throw golden::InputError(place, fmt::format("unknown '{}'; cbvh sim --list-config lists all", name));
}

SimConfig load_sim_config(const std::string& name_or_file) {
  SimConfig config;
  for (const NamedConfig& named : kNamedConfigs) {
    if (name_or_file != named.name) continue;
    config.output = named.output;
    config.code = named.code;
    config.treelet = named.treelet;
    return config;
  }
  if (!name_or_file.ends_with(".json")) {
    throw golden::InputError("--config", fmt::format("unknown '{}', want a .json file or one of {}", name_or_file,
                                                     fmt::join(sim_config_names(), ", ")));
  }
  const Json json = Json::parse(read_text_file(name_or_file), nullptr, false);
  if (!json.is_object()) throw golden::InputError(name_or_file, "want a JSON object of names and values");
  for (const auto& [name, value] : json.items()) {
    set_sim_parameter(config, name + "=" + (value.is_string() ? value.get<std::string>() : value.dump()), name_or_file);
  }
  return config;
}

void check_sim_config(const SimConfig& config) {
  check_range("treelet", config.treelet, 1, 8);
  check_range("bits", config.bits, 4, golden::kMostPackedBits);
  if (config.min_scale && (*config.min_scale < -149 || *config.min_scale > 127))
    throw golden::InputError("min_scale", fmt::format("found {}, want auto or -149..127", *config.min_scale));
  constexpr unsigned kRecordBytes = 32;
  check_range("buffer_records", config.buffer_records, 2, 1U << 16);
  if (config.scratchpad_bytes % kRecordBytes != 0 ||
      config.scratchpad_bytes / 2 < config.buffer_records * kRecordBytes) {
    throw golden::InputError(
        "scratchpad_bytes",
        fmt::format("found {}, want a multiple of {} that holds two run buffers of {} boxes: {} or more",
                    config.scratchpad_bytes, kRecordBytes, config.buffer_records,
                    2 * kRecordBytes * config.buffer_records));
  }
  check_range("scratchpad_bytes", config.scratchpad_bytes, 2 * kRecordBytes, 1U << 28);
  check_range("refill_lines", config.refill_lines, 1, 1U << 10);
  check_range("reader_outstanding", config.reader_outstanding, 1, 1U << 10);
  check_range("merger_outstanding", config.merger_outstanding, 1, 1U << 10);
  check_range("run_skew_lines", config.run_skew_lines, 0, 1U << 10);
  check_range("combining_lines", config.combining_lines, 1, 1U << 16);
  check_power_of_two("combining_lines", config.combining_lines);
  check_range("gather_lines", config.gather_lines, 2, 1U << 16);
  check_power_of_two("gather_lines", config.gather_lines);
  check_range("gather_outstanding", config.gather_outstanding, 1, 1U << 10);
  check_range("gather_queue", config.gather_queue, 2, 1U << 12);
  check_range("max_triangles", config.max_triangles, 1, 1U << 27);
  check_range("ideal_latency", config.ideal_latency, 1, 1U << 16);
  check_range("watchdog_cycles", config.watchdog_cycles, 1000, 1U << 30);
  if (const auto wrong = config.dram.check()) throw golden::InputError("dram", *wrong);
}

}  // namespace cbvh::testbench
