// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/report_page/plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

namespace cbvh::testbench {

namespace {

constexpr double kLoneMark = 1.5;       ///< size of a mark that no line joins to others
constexpr std::size_t kMostMarks = 40;  ///< of a joined series; more would hide its line

/// The inside of a plot, between its axes.
struct Area {
  double left;
  double right;
  double top;
  double bottom;
};

/// The mark of a series, around the origin.
std::string mark_path(std::size_t style) {
  constexpr std::array<const char*, kSeriesStyles> kPaths = {
      "M-4,0a4,4 0 1,0 8,0a4,4 0 1,0 -8,0z",
      "M-3.6,-3.6h7.2v7.2h-7.2z",
      "M0,-4.8L4.6,3.6H-4.6z",
      "M0,-5L5,0L0,5L-5,0z",
      "M0,4.8L4.6,-3.6H-4.6z",
      "M-4,-1.5H-1.5V-4H1.5V-1.5H4V1.5H1.5V4H-1.5V1.5H-4z",
      "M-4,-4H4L-4,4H4z",
      "M0,-5L1.5,-1.6L5,-1.6L2.2,0.9L3.2,4.6L0,2.4L-3.2,4.6L-2.2,0.9L-5,-1.6L-1.5,-1.6z",
  };
  return kPaths.at(style);
}

std::string style_class(std::size_t series) { return fmt::format("s{}", series % kSeriesStyles); }

Markup mark(std::size_t series, double x, double y, double size, const std::string& meaning) {
  return element(
      "path",
      {{"class", style_class(series) + " mark"},
       {"d", mark_path(series % kSeriesStyles)},
       {"transform", fmt::format("translate({} {}) scale({})", coordinate(x), coordinate(y), coordinate(size))}},
      meaning.empty() ? Markup() : element("title", meaning));
}

Markup legend(const Plot& plot) {
  Markup items;
  for (std::size_t i = 0; i < plot.series.size(); ++i) {
    Markup sample;
    if (plot.joined) sample += line(0, 7, 34, 7, style_class(i) + " line");
    sample += mark(i, 17, 7, 1.2, "");
    Markup item = element("svg", {{"class", "sample"}, {"viewBox", "0 0 34 14"}, {"aria-hidden", "true"}}, sample);
    item += Markup::text(plot.series[i].name);
    items += element("li", Attributes{}, item);
  }
  return element("ul", {{"class", "legend"}}, items);
}

/// Only points that can be drawn; series without any are gone.
Plot drawable(Plot plot) {
  for (Series& series : plot.series)
    std::erase_if(series.points, [](const Point& p) { return !can_be_drawn(p.x) || !can_be_drawn(p.y); });
  std::erase_if(plot.series, [](const Series& series) { return series.points.empty(); });
  return plot;
}

std::vector<double> values(const Plot& plot, double Point::*coordinate_of_point) {
  std::vector<double> all;
  for (const Series& series : plot.series) {
    for (const Point& point : series.points) all.push_back(point.*coordinate_of_point);
  }
  return all;
}

Markup axes(const Plot& plot, const Area& area, const Scale& x, const Scale& y) {
  Markup markup;
  for (const double tick : y.ticks()) {
    markup += line(area.left, y.place(tick), area.right, y.place(tick), "grid");
    markup += label(area.left - 7, y.place(tick) + 4, Anchor::end, tick_text(tick));
  }
  for (const double tick : x.ticks()) {
    markup += line(x.place(tick), area.bottom, x.place(tick), area.bottom + 5, "axis");
    markup += label(x.place(tick), area.bottom + 19, Anchor::middle, tick_text(tick));
  }
  markup += line(area.left, area.bottom, area.right, area.bottom, "axis");
  markup += label((area.left + area.right) / 2, area.bottom + 40, Anchor::middle, plot.x.label, "label");
  const double middle = (area.top + area.bottom) / 2;
  markup += element("text",
                    {{"class", "label"},
                     {"text-anchor", "middle"},
                     {"transform", fmt::format("translate(15 {}) rotate(-90)", coordinate(middle))}},
                    plot.y.label);
  return markup;
}

std::string meaning(const Plot& plot, const Series& series, const Point& point) {
  return fmt::format("{}{}{}: {} {}, {} {}", series.name, point.name.empty() ? "" : ", ", point.name, plot.x.label,
                     figure_text(point.x), plot.y.label, figure_text(point.y));
}

Markup draw_series(const Plot& plot, std::size_t index, const Scale& x, const Scale& y) {
  const Series& series = plot.series[index];
  Markup markup;
  if (plot.joined) {
    std::string path;
    for (const Point& point : series.points)
      path +=
          fmt::format("{}{},{}", path.empty() ? "M" : "L", coordinate(x.place(point.x)), coordinate(y.place(point.y)));
    markup += element("path", {{"class", style_class(index) + " line"}, {"d", path}});
  }
  const std::size_t stride = plot.joined ? (series.points.size() + kMostMarks - 1) / kMostMarks : 1;
  for (std::size_t i = 0; i < series.points.size(); i += stride) {
    const Point& point = series.points[i];
    markup +=
        mark(index, x.place(point.x), y.place(point.y), plot.joined ? 1 : kLoneMark, meaning(plot, series, point));
  }
  return markup;
}

std::string description(const Plot& plot) {
  std::string text = fmt::format("{} over {}.", plot.y.label, plot.x.label);
  for (const Series& series : plot.series) {
    const auto [least, most] = std::minmax_element(series.points.begin(), series.points.end(),
                                                   [](const Point& a, const Point& b) { return a.y < b.y; });
    text += fmt::format(" {}: {} points, least {} at {}, most {} at {}.", series.name, series.points.size(),
                        figure_text(least->y), figure_text(least->x), figure_text(most->y), figure_text(most->x));
  }
  return text;
}

/// Joined: a row for every x, a column for every series. Otherwise a row for every point.
void add_table(const Plot& plot, Drawing& drawing) {
  if (!plot.joined) {
    drawing.headings = {"series", "point", plot.x.label, plot.y.label};
    for (const Series& series : plot.series) {
      for (const Point& p : series.points)
        drawing.rows.push_back({series.name, p.name, figure_text(p.x), figure_text(p.y)});
    }
    return;
  }
  drawing.headings = {plot.x.label};
  std::map<double, std::vector<std::string>> rows;
  for (std::size_t i = 0; i < plot.series.size(); ++i) {
    drawing.headings.push_back(plot.series[i].name);
    for (const Point& point : plot.series[i].points) {
      std::vector<std::string>& row = rows[point.x];
      row.resize(plot.series.size() + 1, "-");
      row[0] = figure_text(point.x);
      row[i + 1] = figure_text(point.y);
    }
  }
  for (const auto& [x, row] : rows) drawing.rows.push_back(row);
}

}  // namespace

Markup draw(const Plot& wanted, Figures& figures) {
  const Plot plot = drawable(wanted);
  if (plot.series.empty()) return {};
  Drawing drawing{plot.small ? 310.0 : 760.0, plot.small ? 220.0 : 340.0, {}, {}, {}, {}};
  const Area area{66, drawing.width - 18, 14, drawing.height - 50};
  const Scale x(plot.x, values(plot, &Point::x), area.left + 12, area.right - 12);
  const Scale y(plot.y, values(plot, &Point::y), area.bottom, area.top);
  drawing.content = axes(plot, area, x, y);
  for (std::size_t i = 0; i < plot.series.size(); ++i) drawing.content += draw_series(plot, i, x, y);
  if (plot.series.size() > 1) drawing.legend = legend(plot);
  add_table(plot, drawing);
  return figure({plot.title, description(plot)}, drawing, figures.next());
}

}  // namespace cbvh::testbench
