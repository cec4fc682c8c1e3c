// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "testbench/report_page/markup.h"

namespace cbvh::testbench {

/// The figures of a page, counted: their numbers make the names that tie a drawing to its title and description.
class Figures {
 public:
  unsigned next() { return ++count_; }

 private:
  unsigned count_ = 0;
};

/// What every figure has beside its drawing.
struct Caption {
  std::string title;
  std::string description;  ///< what is seen, for who does not see it
};

/// A drawing in SVG of `width` by `height`, with its caption, its legend, and its figures as a table that unfolds.
struct Drawing {
  double width;
  double height;
  Markup content;
  Markup legend;
  std::vector<std::string> headings;
  std::vector<std::vector<std::string>> rows;  ///< the table's; the first cell names the row
};

Markup figure(const Caption& caption, const Drawing& drawing, unsigned number);

/// A coordinate of a drawing, to a hundredth.
std::string coordinate(double value);
/// A figure of a drawing's table: six digits.
std::string figure_text(double value);
/// At most `most` characters, the last an ellipsis when some are left out.
std::string shorten(const std::string& text, std::size_t most);

/// Where a text of a drawing stands to its point.
enum class Anchor { start, middle, end };
Markup label(double x, double y, Anchor anchor, const std::string& text, const std::string& css_class = "tick");
Markup line(double x1, double y1, double x2, double y2, const std::string& css_class);

}  // namespace cbvh::testbench
