// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "testbench/report_page/figure.h"
#include "testbench/report_page/scale.h"

namespace cbvh::testbench {

struct Point {
  double x;
  double y;
  std::string name = {};  ///< of the point; shown when the pointer rests on it, and in the table
};

/// Points of one kind. Every series of a plot has a colour, a dash pattern and a mark of its own.
struct Series {
  std::string name;
  std::vector<Point> points;
};

constexpr std::size_t kSeriesStyles = 8;  ///< more series than these begin anew

/// Points over two axes.
struct Plot {
  std::string title;
  Axis x;
  Axis y;
  std::vector<Series> series;
  bool joined = true;  ///< by lines; all series then have one value for an x at most
  bool small = false;  ///< one of several beside each other
};

/// Nothing without a point. Points that cannot be drawn (scale.h) are left out.
Markup draw(const Plot& plot, Figures& figures);

}  // namespace cbvh::testbench
