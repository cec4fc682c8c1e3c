// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "testbench/report_page/figure.h"

namespace cbvh::testbench {

/// One bar: its parts' lengths one after the other, none negative.
struct Bar {
  std::string group;  ///< bars of one group follow each other below its name
  std::string name;
  std::vector<double> parts;
  std::optional<double> reference = {};  ///< marked beside the bar
};

constexpr std::size_t kBarParts = 5;  ///< fillings there are

/// Horizontal bars from zero, below each other. Parts differ in colour and hatching.
struct BarChart {
  std::string title;
  std::string axis;                ///< with the unit
  std::vector<std::string> parts;  ///< their names; at most kBarParts
  std::vector<Bar> bars;
  std::string reference = {};  ///< what the marks are
  bool totals = true;          ///< stand behind the bars
};

/// Nothing without a bar. Bars with a part that is negative or cannot be drawn (scale.h) are left out.
Markup draw(const BarChart& chart, Figures& figures);

}  // namespace cbvh::testbench
