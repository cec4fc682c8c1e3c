// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/sim/sim_options.h"

#include <fmt/format.h>

namespace cbvh::testbench {

void SimOptions::add_to(const Command& command) {
  command
      .add_option("--config", config_,
                  fmt::format("{}, or a .json file of names and values", fmt::join(sim_config_names(), ", ")))
      .capture_default_str();
  command.add_option("--set", assignments_, "NAME=VALUE: one configuration value; may be repeated")
      .type_name("NAME=VALUE");
  command.add_flag("--list-config", list_, "list all configuration values and end");
  command.add_flag("--no-utilisation", no_utilisation_, "do not watch the modules: faster");
  command.add_option("--vcd", waveform_, "write waveforms of the channels (IEEE 1364; GTKWave opens them)")
      .type_name("FILE");
  command.add_option("--scope", scope_, "only the channels of this module").type_name("MODULE");
  command.add_option("--cycles", cycles_, "only these cycles").type_name("FIRST:LAST");
  command.add_option("--dram-trace", trace_, "write the DRAM's accesses, `0xADDRESS R|W`, as Ramulator reads them")
      .type_name("FILE");
  command.add_option("--shuffle", shuffle_, "evaluate the modules in a new random order every cycle").type_name("SEED");
  command.add_option("--stalls", stalls_, "hold requests and answers at the memory's ports back at random")
      .type_name("SEED");
}

SimRequest SimOptions::request() const {
  SimRequest request;
  request.config = load_sim_config(config_);
  for (const std::string& assignment : assignments_) set_sim_parameter(request.config, assignment, "--set");
  check_sim_config(request.config);
  request.machine.watchdog_cycles = request.config.watchdog_cycles;
  request.machine.utilisation = !no_utilisation_;
  request.machine.shuffle = shuffle_;
  request.machine.stalls = stalls_;
  if (waveform_.empty() && !(scope_.empty() && cycles_.empty()))
    throw golden::InputError(scope_.empty() ? "--cycles" : "--scope", "goes with --vcd");
  if (!waveform_.empty()) {
    WaveformRequest waveform{waveform_, scope_};
    if (!cycles_.empty()) parse_cycles(cycles_, waveform);
    request.machine.waveform = waveform;
  }
  request.trace_path = trace_;
  if (!trace_.empty() && request.config.memory != MemoryKind::dram)
    throw golden::InputError("--dram-trace", "the ideal memory has no DRAM accesses; want memory=dram");
  return request;
}

bool SimOptions::lists_config(const SimConfig& config, const Output& output) const {
  if (!list_) return false;
  std::string text = fmt::format("{:<24} {:>18} {}\n", "name", "value", "meaning [unit or choices]");
  for (const SimParameter& parameter : sim_parameters()) {
    text += fmt::format("{:<24} {:>18} {}{}\n", parameter.name, parameter.get(config), parameter.description,
                        parameter.unit.empty() ? "" : " [" + parameter.unit + "]");
  }
  output.text(text);
  output.json(to_json(config));
  return true;
}

Json to_json(const SimConfig& config) {
  Json json = Json::object();
  for (const SimParameter& parameter : sim_parameters()) json[parameter.name] = parameter.get(config);
  return json;
}

}  // namespace cbvh::testbench
