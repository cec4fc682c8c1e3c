// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/report_page/figure.h"

#include <fmt/format.h>

#include "testbench/report_page/table.h"

namespace cbvh::testbench {

Markup figure(const Caption& caption, const Drawing& drawing, unsigned number) {
  const std::string title_id = fmt::format("figure{}-title", number);
  const std::string description_id = fmt::format("figure{}-description", number);
  Markup svg = element("title", {{"id", title_id}}, caption.title);
  svg += element("desc", {{"id", description_id}}, caption.description);
  svg += drawing.content;
  const std::string box = fmt::format("0 0 {} {}", coordinate(drawing.width), coordinate(drawing.height));
  Markup content = element("figcaption", caption.title);
  content += drawing.legend;
  content += element(
      "div", {{"class", "scroll"}},
      element("svg",
              {{"role", "img"}, {"aria-labelledby", title_id}, {"aria-describedby", description_id}, {"viewBox", box}},
              svg));
  Markup details = element("summary", "the figures as a table");
  details += plain_table(caption.title, drawing.headings, drawing.rows);
  content += element("details", Attributes{}, details);
  return element("figure", {{"class", drawing.width < 500 ? "small" : "wide"}}, content);
}

std::string coordinate(double value) {
  std::string text = fmt::format("{:.2f}", value);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

std::string figure_text(double value) { return fmt::format("{:.6g}", value); }

std::string shorten(const std::string& text, std::size_t most) {
  std::size_t characters = 0;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if ((static_cast<unsigned char>(text[i]) & 0xC0) == 0x80) continue;
    if (++characters == most) kept = i;
    if (characters > most) return text.substr(0, kept) + "\u2026";
  }
  return text;
}

Markup label(double x, double y, Anchor anchor, const std::string& text, const std::string& css_class) {
  const char* const where = anchor == Anchor::start ? "start" : anchor == Anchor::middle ? "middle" : "end";
  return element("text", {{"class", css_class}, {"x", coordinate(x)}, {"y", coordinate(y)}, {"text-anchor", where}},
                 text);
}

Markup line(double x1, double y1, double x2, double y2, const std::string& css_class) {
  return element("line", {{"class", css_class},
                          {"x1", coordinate(x1)},
                          {"y1", coordinate(y1)},
                          {"x2", coordinate(x2)},
                          {"y2", coordinate(y2)}});
}

}  // namespace cbvh::testbench
