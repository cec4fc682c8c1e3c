// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/report_page/bars.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "testbench/report_page/scale.h"

namespace cbvh::testbench {

namespace {

constexpr double kWidth = 760;
constexpr double kLeft = 214;
constexpr double kRight = kWidth - 110;  ///< the totals stand beyond
constexpr double kRow = 21;
constexpr double kBar = 14;
constexpr double kGroup = 28;
constexpr std::size_t kLabelCharacters = 28;

double total(const Bar& bar) { return std::accumulate(bar.parts.begin(), bar.parts.end(), 0.0); }

bool is_drawable(const Bar& bar) {
  return !bar.parts.empty() && can_be_drawn(bar.reference.value_or(0)) &&
         std::all_of(bar.parts.begin(), bar.parts.end(), [](double part) { return can_be_drawn(part) && part >= 0; });
}

Markup rectangle(double x, double y, double width, double height, const Attributes& more, const Markup& content = {}) {
  Attributes attributes = {
      {"x", coordinate(x)}, {"y", coordinate(y)}, {"width", coordinate(width)}, {"height", coordinate(height)}};
  attributes.insert(attributes.end(), more.begin(), more.end());
  return element("rect", attributes, content);
}

std::string hatching_id(unsigned number, std::size_t part) { return fmt::format("figure{}-part{}", number, part); }

/// What tells parts apart without their colours: plain, stripes of two directions, dots, a grid.
Markup hatchings(unsigned number, std::size_t parts) {
  constexpr const char* kLines[kBarParts] = {"", "M0,8L8,0M-2,2L2,-2M6,10L10,6", "M2,2h2v2h-2zM6,6h2v2h-2z",
                                             "M0,0L8,8M-2,6L2,10M6,-2L10,2", "M0,4H8M4,0V8"};
  Markup patterns;
  for (std::size_t i = 0; i < parts; ++i) {
    Markup content = element("rect", {{"class", fmt::format("f{}", i)}, {"width", "8"}, {"height", "8"}});
    content += element("path", {{"class", "hatch"}, {"d", kLines[i]}});
    patterns += element(
        "pattern",
        {{"id", hatching_id(number, i)}, {"width", "8"}, {"height", "8"}, {"patternUnits", "userSpaceOnUse"}}, content);
  }
  return element("defs", Attributes{}, patterns);
}

std::string fill(unsigned number, std::size_t part) { return fmt::format("url(#{})", hatching_id(number, part)); }

Markup reference_mark(double x, double y, const std::string& meaning) {
  return element("path",
                 {{"class", "reference"},
                  {"d", "M0,-6L5,0L0,6L-5,0z"},
                  {"transform", fmt::format("translate({} {})", coordinate(x), coordinate(y))}},
                 meaning.empty() ? Markup() : element("title", meaning));
}

Markup legend(const BarChart& chart, unsigned number) {
  if (chart.parts.size() < 2 && chart.reference.empty()) return {};
  Markup items;
  const auto add = [&](const Markup& sample, const std::string& name) {
    Markup item = element("svg", {{"class", "sample"}, {"viewBox", "0 0 34 14"}, {"aria-hidden", "true"}}, sample);
    item += Markup::text(name);
    items += element("li", Attributes{}, item);
  };
  for (std::size_t i = 0; i < chart.parts.size(); ++i)
    add(rectangle(5, 0, 24, 14, {{"fill", fill(number, i)}}), chart.parts[i]);
  if (!chart.reference.empty()) add(reference_mark(17, 7, ""), chart.reference + ", in brackets");
  return element("ul", {{"class", "legend"}}, items);
}

/// A bar with its name before it and its total behind it; at the edge, with the reference in brackets, when there is
/// one.
Markup draw_bar(const BarChart& chart, const Bar& bar, const Scale& x, double top, unsigned number) {
  const double middle = top + kRow / 2;
  const std::string full_name = bar.group.empty() ? bar.name : bar.group + ", " + bar.name;
  Markup content = element("title", bar.name);
  content += label(kLeft - 9, middle + 4, Anchor::end, shorten(bar.name, kLabelCharacters));
  double sum = 0;
  for (std::size_t i = 0; i < bar.parts.size(); ++i) {
    const double from = x.place(sum);
    sum += bar.parts[i];
    content +=
        rectangle(from, middle - kBar / 2, x.place(sum) - from, kBar, {{"fill", fill(number, i)}},
                  element("title", fmt::format("{}: {} {}", full_name, chart.parts[i], figure_text(bar.parts[i]))));
  }
  if (!bar.reference) {
    if (chart.totals) content += label(x.place(sum) + 7, middle + 4, Anchor::start, tick_text(sum), "value");
    return element("g", Attributes{}, content);
  }
  const std::string reference = fmt::format("{}: {} {}", full_name, chart.reference, figure_text(*bar.reference));
  content += reference_mark(x.place(*bar.reference), middle, reference);
  content += label(kWidth, middle + 4, Anchor::end, fmt::format("{:.3g} ({:.3g})", sum, *bar.reference), "value");
  return element("g", Attributes{}, content);
}

std::string description(const BarChart& chart) {
  std::string text = chart.axis + ".";
  for (const Bar& bar : chart.bars) {
    text += fmt::format(" {}{}{}: {}", bar.group, bar.group.empty() ? "" : ", ", bar.name, figure_text(total(bar)));
    if (bar.reference) text += fmt::format(" ({}: {})", chart.reference, figure_text(*bar.reference));
    text += '.';
  }
  return text;
}

void add_table(const BarChart& chart, Drawing& drawing) {
  const bool grouped =
      std::any_of(chart.bars.begin(), chart.bars.end(), [](const Bar& bar) { return !bar.group.empty(); });
  if (grouped) drawing.headings.emplace_back("group");
  drawing.headings.emplace_back("bar");
  drawing.headings.insert(drawing.headings.end(), chart.parts.begin(), chart.parts.end());
  if (chart.parts.size() > 1) drawing.headings.emplace_back("total");
  if (!chart.reference.empty()) drawing.headings.push_back(chart.reference);
  for (const Bar& bar : chart.bars) {
    std::vector<std::string> row;
    if (grouped) row.push_back(bar.group);
    row.push_back(bar.name);
    for (const double part : bar.parts) row.push_back(figure_text(part));
    if (chart.parts.size() > 1) row.push_back(figure_text(total(bar)));
    if (!chart.reference.empty()) row.push_back(bar.reference ? figure_text(*bar.reference) : "-");
    drawing.rows.push_back(row);
  }
}

}  // namespace

Markup draw(const BarChart& wanted, Figures& figures) {
  BarChart chart = wanted;
  std::erase_if(chart.bars, [](const Bar& bar) { return !is_drawable(bar); });
  if (chart.bars.empty()) return {};
  const unsigned number = figures.next();
  std::vector<double> ends;
  for (const Bar& bar : chart.bars) {
    ends.push_back(total(bar));
    if (bar.reference) ends.push_back(*bar.reference);
  }
  const Scale x({chart.axis, false, true}, ends, kLeft, kRight);
  Markup bars;
  double bottom = 4;
  std::string group;
  for (const Bar& bar : chart.bars) {
    if (bar.group != group) {
      bars += label(4, bottom + kGroup - 8, Anchor::start, shorten(bar.group, 80), "group");
      bottom += kGroup;
      group = bar.group;
    }
    bars += draw_bar(chart, bar, x, bottom, number);
    bottom += kRow;
  }
  bottom += 6;
  Drawing drawing{kWidth, bottom + 46, hatchings(number, chart.parts.size()), legend(chart, number), {}, {}};
  for (const double tick : x.ticks()) {
    drawing.content += line(x.place(tick), 4, x.place(tick), bottom, tick == 0 ? "axis" : "grid");
    drawing.content += label(x.place(tick), bottom + 16, Anchor::middle, tick_text(tick));
  }
  drawing.content += bars;
  drawing.content += label((kLeft + kRight) / 2, bottom + 37, Anchor::middle, chart.axis, "label");
  add_table(chart, drawing);
  return figure({chart.title, description(chart)}, drawing, number);
}

}  // namespace cbvh::testbench
