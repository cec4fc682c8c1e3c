// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "testbench/report_page/plot.h"
#include "testbench/report_page/result.h"
#include "testbench/report_page/table.h"

/// `cbvh build`: one tree.
namespace cbvh::testbench {

namespace {

/// Every fact of the result that is one value.
Markup facts(const Json& json) {
  std::vector<std::vector<std::string>> rows;
  for (const auto& [name, value] : json.items()) {
    if (value.is_structured()) continue;
    rows.push_back({name, value.is_number_float() ? figure_text(value.get<double>()) : cell_text(value, 0)});
  }
  return plain_table("Facts", {"fact", "value"}, rows);
}

Tally tally(const Json& json) {
  Tally tally = one_check(json.at("identical").get<bool>());
  tally += one_check(count(json, "violations") == 0);
  return tally;
}

Markup show(const Json& json, Figures& figures) {
  Markup markup = element(
      "h3", fmt::format("{}, built by {}", json.at("scene").get<std::string>(), json.at("builder").get<std::string>()));
  Series series{"backtracks", {}};
  for (const Json& backtracks : json.at("backtrack_depth_histogram"))
    series.points.push_back({static_cast<double>(series.points.size()), backtracks.get<double>()});
  if (!series.points.empty()) series.points.erase(series.points.begin());  // depth 0 is no backtrack
  markup +=
      draw(Plot{"Depth of backtracks", {"depth, levels", false, false, true}, {"backtracks", true, false}, {series}},
           figures);
  Markup details = element("summary", "all facts");
  details += facts(json);
  markup += element("details", {{"class", "long"}}, details);
  return markup;
}

}  // namespace

ResultKind build_kind() {
  return {"build", "cbvh build --json", {"scene", "topdown_digest", "backtrack_depth_histogram"}, Chapter::runs, tally,
          show};
}

}  // namespace cbvh::testbench
