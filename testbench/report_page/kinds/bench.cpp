// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "testbench/report_page/plot.h"
#include "testbench/report_page/result.h"
#include "testbench/report_page/table.h"

/// `cbvh bench`: speed of the models, and of builds and simulations of growing scenes.
namespace cbvh::testbench {

namespace {

std::vector<Json> builds(const Json& json) {
  std::vector<Json> rows = {json.at("build")};
  rows.insert(rows.end(), json.at("scaling").begin(), json.at("scaling").end());
  return rows;
}

std::vector<Json> sims(const Json& json) { return {json.at("sim").begin(), json.at("sim").end()}; }

Tally tally(const Json& json) {
  const Json& axis = json.at("axis_compressor");
  const std::uint64_t failures = count(axis, "failures");
  Tally tally{count(axis, "cases") - std::min(count(axis, "cases"), failures), failures, 0};
  for (const Json& row : builds(json)) tally += one_check(row.at("identical").get<bool>());
  for (const Json& row : sims(json)) tally += one_check(row.at("identical").get<bool>());
  return tally;
}

Series speed(const std::string& name, const std::vector<Json>& rows) {
  Series series{name, {}};
  for (const Json& row : rows) {
    const double triangles = row.at("triangles");
    const double seconds = row.at("seconds");
    const std::string scene = row.at("scene");
    series.points.push_back({triangles, triangles / seconds, scene});
  }
  std::sort(series.points.begin(), series.points.end(), [](const Point& a, const Point& b) { return a.x < b.x; });
  return series;
}

Markup show(const Json& json, Figures& figures) {
  std::vector<std::vector<std::string>> rows;
  for (const auto& [name, value] : json.at("axis_compressor").items())
    rows.push_back({name, value.is_number_float() ? tick_text(value.get<double>()) : value.dump()});
  Markup markup = element("h3", "Axis compressor");
  markup += plain_table("Axis compressor", {"figure", "value"}, rows);
  Plot plot{"Speed of builds and simulations", {"triangles", true, false}, {"triangles a second", true, false}, {}};
  plot.series.push_back(speed("build: stream compressor, ideal memory", builds(json)));
  plot.series.push_back(speed("sim: whole pipeline, DRAM", sims(json)));
  markup += draw(plot, figures);
  return markup;
}

}  // namespace

ResultKind bench_kind() {
  return {"benchmark", "cbvh bench --json", {"axis_compressor", "build", "scaling", "sim"}, Chapter::speed, tally,
          show};
}

}  // namespace cbvh::testbench
