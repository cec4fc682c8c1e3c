// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/report_page/kinds/machine.h"

#include <fmt/format.h>

#include "testbench/report_page/bars.h"
#include "testbench/report_page/table.h"

namespace cbvh::testbench {

namespace {

constexpr double kLineBytes = 64;

Markup figures_of(const Json& result) {
  const auto number = [&](const char* key) { return result.at(key).get<double>(); };
  return plain_table(
      "The run",
      {"triangles", "pairs", "backtracks", "cycles", "over the memory's bound", "ms at its clock",
       "bytes over the baseline's", "as modelled", "tree"},
      {{result.at("triangles").dump(), result.at("pairs").dump(), result.at("hardware_backtracks").dump(),
        result.at("cycles").dump(), fmt::format("{:.3f}", number("over_bandwidth_bound")),
        fmt::format("{:.4f}", number("milliseconds")), fmt::format("{:.3f}", number("traffic_ratio")),
        fmt::format("{:.3f}", number("model_traffic_ratio")),
        result.at("identical").get<bool>() ? "identical" : "DIFFERS"}});
}

BarChart traffic(const Json& result) {
  BarChart chart{"Memory traffic by purpose", "bytes in lines on the bus", {"read", "written"}, {}};
  for (const Json& part : result.at("traffic")) {
    chart.bars.push_back({"",
                          part.at("purpose"),
                          {kLineBytes * static_cast<double>(count(part, "reads")),
                           kLineBytes * static_cast<double>(count(part, "writes"))}});
  }
  return chart;
}

BarChart utilisation(const Json& result) {
  BarChart chart{"What the modules did",
                 "per cent of the cycles",
                 {"busy", "waits for input", "waits for its output", "idle"},
                 {},
                 {},
                 false};
  for (const auto& [module, cycles] : result.at("utilisation").items()) {
    Bar bar{"", module, {}};
    double all = 0;
    for (const char* const key : {"busy", "stalled_on_input", "stalled_on_output", "idle"}) {
      bar.parts.push_back(static_cast<double>(count(cycles, key)));
      all += bar.parts.back();
    }
    for (double& part : bar.parts) part *= all > 0 ? 100 / all : 0;
    chart.bars.push_back(bar);
  }
  return chart;
}

}  // namespace

Tally tally_machine(const Json& result) { return one_check(result.at("pass").get<bool>()); }

Markup show_machine(const std::string& title, const Json& result, Figures& figures) {
  Markup markup = element("h3", title);
  markup += figures_of(result);
  markup += element("p", "Bottleneck: " + result.at("bottleneck").get<std::string>() + ".");
  markup += draw(traffic(result), figures);
  markup += draw(utilisation(result), figures);
  return markup;
}

}  // namespace cbvh::testbench
