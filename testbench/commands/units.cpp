// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <memory>

#include "testbench/backend/backend.h"
#include "testbench/command_line.h"
#include "testbench/output.h"
#include "vectors/registry.h"

namespace cbvh::testbench {

namespace {

struct Options {
  std::string unit;
  Output output;
};

std::vector<std::string> faces_of(const vectors::UnitDescription& unit) {
  std::vector<std::string> faces;
  for (MakeBackend* make : all_backends()) {
    const auto backend = make();
    if (backend->has(unit)) faces.push_back(backend->name());
  }
  return faces;
}

Json fields_to_json(const vectors::PayloadCodec& codec) {
  Json fields = Json::array();
  for (const auto& leaf : codec.leaves) {
    const char* kinds[] = {"unsigned", "signed", "binary32"};
    fields.push_back(
        {{"name", leaf.name}, {"width", leaf.width}, {"kind", kinds[static_cast<std::size_t>(leaf.kind)]}});
  }
  return fields;
}

Json unit_to_json(const vectors::UnitDescription& unit) {
  const int bits = unit.bits.size() > 1 ? vectors::Parameters().bits : unit.bits[0];
  return {{"name", unit.name},
          {"summary", unit.summary},
          {"latency", unit.latency_text},
          {"stateful", unit.stateful},
          {"bits", unit.bits},
          {"treelets", unit.treelets},
          {"faces", faces_of(unit)},
          {"classes", unit.classes},
          {"stimulus", fields_to_json(unit.stimulus(bits))},
          {"response", fields_to_json(unit.response(bits))}};
}

int run(const Options& options) {
  if (!options.unit.empty()) vectors::find_unit(options.unit);
  std::string text = fmt::format("{:<28} {:<20} {:>8} {:>8}  {:<40} {}\n", "unit", "faces", "stimulus", "response",
                                 "latency", "summary");
  Json all = Json::array();
  for (const vectors::UnitDescription& unit : vectors::units()) {
    if (!options.unit.empty() && unit.name != options.unit) continue;
    const Json& json = all.emplace_back(unit_to_json(unit));
    text += fmt::format("{:<28} {:<20} {:>8} {:>8}  {:<40} {}\n", unit.name,
                        fmt::format("{}", fmt::join(faces_of(unit), ",")), json["stimulus"].size(),
                        json["response"].size(), unit.latency_text, unit.summary);
    if (!options.unit.empty())
      text += fmt::format("fields at bits=6: {}\nclasses: {}\n", unit.field_names(6), fmt::join(unit.classes, ", "));
  }
  options.output.text(text);
  options.output.json({{"units", all}});
  return kPass;
}

}  // namespace

void add_units_command(CommandLine& commands) {
  auto options = std::make_shared<Options>();
  const Command command =
      commands.add("units", "The registry of units: faces present, fields of stimulus and response, latency",
                   [options] { return run(*options); });
  command.add_option("unit", options->unit, "show one unit, with its fields and classes").type_name("UNIT");
  options->output.add_option(command);
}

}  // namespace cbvh::testbench
