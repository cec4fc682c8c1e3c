// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/report_page/kinds/table_plots.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <map>
#include <optional>
#include <utility>

#include "testbench/report_page/bars.h"
#include "testbench/report_page/plot.h"

namespace cbvh::testbench {

namespace {

using Draw = Markup(const Json& tables, Figures& figures);

std::string text(const Json& row, const char* key) { return row.at(key).get<std::string>(); }

/// Nothing for a figure there is not.
std::optional<double> number(const Json& row, const std::string& key) {
  const Json& value = row.at(key);
  return value.is_null() ? std::nullopt : std::optional<double>(value.get<double>());
}

const Json& rows(const Json& tables, const char* key) { return tables.at(key).at("rows"); }

/// The series of this name, added when there is none.
Series& series_of(std::vector<Series>& all, const std::string& name) {
  const auto found = std::find_if(all.begin(), all.end(), [&](const Series& series) { return series.name == name; });
  if (found != all.end()) return *found;
  return all.emplace_back(Series{name, {}});
}

Markup draw_figure1(const Json& tables, Figures& figures) {
  BarChart chart{"External memory traffic, after Figure 1",
                 "bytes a primitive",
                 {"construction or refit", "separate compression", "backtracking"},
                 {}};
  for (const Json& row : rows(tables, "figure1")) {
    chart.bars.push_back({fmt::format("{}: {}", text(row, "update"), text(row, "trees")),
                          text(row, "strategy"),
                          {number(row, "update_bytes").value_or(0), number(row, "separate_bytes").value_or(0),
                           number(row, "backtracking_bytes").value_or(0)}});
  }
  return draw(chart, figures);
}

Markup draw_table1(const Json& tables, Figures& figures) {
  BarChart chart{
      "Table 1: averages beside the paper's", "share of the baseline's", {"average"}, {}, "the paper's average"};
  for (const Json& row : rows(tables, "table1")) {
    if (const auto average = number(row, "average"))
      chart.bars.push_back({text(row, "quantity"),
                            fmt::format("{}, D = {}", text(row, "code"), row.at("treelet").dump()),
                            {*average},
                            number(row, "paper_average")});
  }
  return draw(chart, figures);
}

Markup draw_table2(const Json& tables, Figures& figures) {
  constexpr const char* kColumns[][2] = {{"float_ms", "float BVH"},
                                         {"top_down_ms", "+ top-down pass"},
                                         {"relative_ms", "streaming R"},
                                         {"modulo_4_ms", "streaming M, D = 4"}};
  BarChart chart{"LBVH runtime at 1 GHz", "milliseconds", {"runtime"}, {}};
  for (const Json& row : rows(tables, "table2")) {
    for (const auto& [key, name] : kColumns) {
      if (const auto value = number(row, key))
        chart.bars.push_back({fmt::format("{} ({})", text(row, "scene"), text(row, "source")), name, {*value}});
    }
  }
  return draw(chart, figures);
}

Markup draw_figure11(const Json& tables, Figures& figures) {
  BarChart chart{
      "LBVH runtime over the float build's, after Figure 11", "average ratio", {"average"}, {}, "the paper's average"};
  for (const Json& row : rows(tables, "figure11")) {
    if (const auto average = number(row, "average"))
      chart.bars.push_back({"", text(row, "configuration"), {*average}, number(row, "paper_average")});
  }
  return draw(chart, figures);
}

Markup draw_figure7(const Json& tables, Figures& figures) {
  std::vector<Plot> plots;
  for (const Json& row : rows(tables, "figure7")) {
    const std::string title = text(row, "scene");
    if (plots.empty() || plots.back().title != title)
      plots.push_back({title,
                       {"depth, levels", false, false, true},
                       {"backtracks", true},
                       {{"relative", {}}, {"modulo", {}}},
                       true,
                       true});
    for (Series& series : plots.back().series)
      series.points.push_back({number(row, "depth").value_or(0), number(row, series.name).value_or(0)});
  }
  Markup multiples;
  for (const Plot& plot : plots) multiples += draw(plot, figures);
  Markup markup = element("h4", "Depth of backtracks by scene, after Figure 7");
  markup += element("div", {{"class", "multiples"}}, multiples);
  return multiples.empty() ? Markup() : markup;
}

/// e_min of a row; "auto" has none.
std::optional<double> exponent(const Json& row) {
  const std::string label = text(row, "min_scale");
  int value = 0;
  const auto [end, error] = std::from_chars(label.data(), label.data() + label.size(), value);
  return error == std::errc() && end == label.data() + label.size() ? std::optional<double>(value) : std::nullopt;
}

Plot figure10_plot(const Json& tables, const std::string& title, const Axis& y,
                   const std::vector<std::array<std::string, 2>>& columns) {
  Plot plot{title, {"minimum scale, e_min", false, false, true}, y, {}};
  for (const auto& [key, name] : columns) {
    Series series{name, {}};
    for (const Json& row : rows(tables, "figure10")) {
      const auto x = exponent(row);
      const auto value = number(row, key);
      if (x && value) series.points.push_back({*x, *value});
    }
    plot.series.push_back(series);
  }
  return plot;
}

Markup draw_figure10(const Json& tables, Figures& figures) {
  Markup markup =
      draw(figure10_plot(tables, "Backtracks over the minimum scale, after Figure 10", {"backtracks a primitive", true},
                         {{"cloth_backtracks_1", "cloth, D = 1"},
                          {"cloth_backtracks_4", "cloth, D = 4"},
                          {"others_backtracks_1", "others, D = 1"},
                          {"others_backtracks_4", "others, D = 4"}}),
           figures);
  markup += draw(figure10_plot(tables, "Quality over the minimum scale, after Figure 10", {"SAH over the best", true},
                               {{"cloth_sah", "cloth"}, {"others_sah", "others"}}),
                 figures);
  return markup;
}

Markup draw_builders(const Json& tables, Figures& figures) {
  Plot plot{"Builders: quality against traffic",
            {"SAH over the first builder's"},
            {"build traffic over the baseline's"},
            {},
            false};
  BarChart chart{"Builders: traffic of building a compressed tree",
                 "bytes over those of a float tree compressed top-down afterwards",
                 {"streaming, modulo codes, D = 4"},
                 {}};
  std::map<std::pair<std::string, std::string>, double> sah;
  for (const Json& row : rows(tables, "builder_trees"))
    sah[{text(row, "scene"), text(row, "builder")}] = number(row, "sah_of_first").value_or(0);
  for (const Json& row : rows(tables, "builder_compression")) {
    const std::string scene = text(row, "scene");
    const std::string builder = text(row, "builder");
    const auto traffic = number(row, "build_traffic_ratio");
    if (!traffic) continue;
    chart.bars.push_back({scene, builder, {*traffic}});
    if (const auto found = sah.find({scene, builder}); found != sah.end())
      series_of(plot.series, builder).points.push_back({found->second, *traffic, scene});
  }
  Markup markup = draw(plot, figures);
  markup += draw(chart, figures);
  return markup;
}

Markup draw_two_level(const Json& tables, Figures& figures) {
  BarChart chart{"Top levels over instances", "SAH of both levels", {"SAH"}, {}};
  for (const Json& row : rows(tables, "two_level")) {
    if (const auto sah = number(row, "sah"))
      chart.bars.push_back({text(row, "scene"), fmt::format("{}, {}", text(row, "top"), text(row, "objects")), {*sah}});
  }
  return draw(chart, figures);
}

Markup draw_space(const Json& tables, Figures& figures) {
  BarChart chart{"Random rays with early termination", "cost over the first tree's", {"cost"}, {}, "the paper's"};
  for (const Json& row : rows(tables, "space")) {
    if (const auto ratio = number(row, "terminating_ratio"))
      chart.bars.push_back({text(row, "scene"), text(row, "tree"), {*ratio}, number(row, "paper_terminating_ratio")});
  }
  return draw(chart, figures);
}

Markup draw_space_overlap(const Json& tables, Figures& figures) {
  Plot plot{"Cost of random rays over the penalty on overlap, after Figure 6",
            {"C_O", true},
            {"cost over that without penalty"},
            {}};
  for (const Json& row : rows(tables, "space_overlap")) {
    const auto overlap = number(row, "overlap");
    const auto ratio = number(row, "terminating_ratio");
    if (overlap && ratio) series_of(plot.series, text(row, "scene")).points.push_back({*overlap, *ratio});
  }
  return draw(plot, figures);
}

/// A plot of one figure over the frames, for every scene and kind of trees.
Markup draw_frames(const Json& tables, const char* key, const Axis& y, Figures& figures) {
  std::vector<Plot> plots;
  for (const Json& row : rows(tables, "two_level_every_frame")) {
    const std::string title = fmt::format("{}: {} trees, {}", y.label, text(row, "trees"), text(row, "scene"));
    auto plot = std::find_if(plots.begin(), plots.end(), [&](const Plot& known) { return known.title == title; });
    if (plot == plots.end()) plot = plots.insert(plots.end(), Plot{title, {"frame", false, false, true}, y, {}});
    const auto value = number(row, key);
    if (value) series_of(plot->series, text(row, "top")).points.push_back({number(row, "frame").value_or(0), *value});
  }
  Markup markup;
  for (const Plot& plot : plots) markup += draw(plot, figures);
  return markup;
}

Markup draw_two_level_frames(const Json& tables, Figures& figures) {
  Markup markup = draw_frames(tables, "build_ms", {"time to build the top level, ms", true}, figures);
  markup += draw_frames(tables, "sah", {"SAH of both levels"}, figures);
  return markup;
}

}  // namespace

Markup draw_table(const std::string& key, const Json& tables, Figures& figures) {
  static const std::map<std::string, Draw*> drawings = {{"figure1", draw_figure1},
                                                        {"table1", draw_table1},
                                                        {"table2", draw_table2},
                                                        {"figure11", draw_figure11},
                                                        {"figure7", draw_figure7},
                                                        {"figure10", draw_figure10},
                                                        {"builder_compression", draw_builders},
                                                        {"space", draw_space},
                                                        {"space_overlap", draw_space_overlap},
                                                        {"two_level", draw_two_level},
                                                        {"two_level_every_frame", draw_two_level_frames}};
  const auto found = drawings.find(key);
  return found == drawings.end() ? Markup() : found->second(tables, figures);
}

}  // namespace cbvh::testbench
