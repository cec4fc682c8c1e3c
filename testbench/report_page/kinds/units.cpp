// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "testbench/report_page/result.h"
#include "testbench/report_page/table.h"

/// `cbvh units`: the registry.
namespace cbvh::testbench {

namespace {

Tally tally(const Json&) { return {}; }

Markup show(const Json& json, Figures&) {
  std::vector<std::vector<std::string>> rows;
  for (const Json& unit : json.at("units")) {
    std::string faces;
    for (const Json& face : unit.at("faces")) faces += (faces.empty() ? "" : ", ") + face.get<std::string>();
    rows.push_back({unit.at("name"), faces, unit.at("latency"), unit.at("summary")});
  }
  Markup details = element("summary", fmt::format("{} units: faces, latency, purpose", rows.size()));
  details += plain_table("The registry", {"unit", "faces", "latency, cycles", "what it does"}, rows);
  return element("details", {{"class", "long"}}, details);
}

}  // namespace

ResultKind units_kind() { return {"registry", "cbvh units --json", {"units"}, Chapter::checks, tally, show}; }

}  // namespace cbvh::testbench
