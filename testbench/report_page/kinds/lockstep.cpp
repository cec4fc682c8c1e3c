// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/report_page/result.h"
#include "testbench/report_page/table.h"

/// `cbvh lockstep`: Verilog twins beside their C++ modules.
namespace cbvh::testbench {

namespace {

Tally tally(const Json& json) { return {count(json, "passed"), count(json, "failed"), 0}; }

Markup show(const Json& json, Figures&) {
  std::vector<std::vector<std::string>> rows;
  for (const Json& result : json.at("results")) {
    const std::string difference = result.at("difference");
    rows.push_back({result.at("twin"), result.at("stalls"), result.at("cycles").dump(), result.at("signals").dump(),
                    result.at("moves").dump(), difference.empty() ? "equal" : difference});
  }
  Markup markup = element("h3", "Verilog twins in lockstep with the C++ modules");
  markup += plain_table("Lockstep", {"twin", "stalls", "cycles", "signals compared", "moves", "verdict"}, rows);
  return markup;
}

}  // namespace

ResultKind lockstep_kind() {
  return {"lockstep run", "cbvh lockstep --json", {"results", "passed", "failed"}, Chapter::checks, tally, show};
}

}  // namespace cbvh::testbench
