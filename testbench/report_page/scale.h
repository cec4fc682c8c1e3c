// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace cbvh::testbench {

/// What an axis of a plot shows.
struct Axis {
  std::string label;         ///< with the unit
  bool logarithmic = false;  ///< 0 stands below all other values; anything negative makes the axis linear
  bool from_zero = false;    ///< a linear axis begins at 0: lengths can be compared
  bool whole = false;        ///< a linear axis has ticks at whole numbers only
};

/// Where values stand along an axis of a plot, in the units of the drawing, and where its ticks are.
class Scale {
 public:
  /// Of all `values`, which can be drawn; without any, of 0..1. The least stands at or after `begin`, the most at or
  /// before `end`; `begin` may be greater than `end`.
  Scale(const Axis& axis, const std::vector<double>& values, double begin, double end);

  double place(double value) const;
  /// 1, 2 or 5 times powers of ten, ascending; the first and the last bound all values.
  const std::vector<double>& ticks() const { return ticks_; }

 private:
  void fit_linear(double least, double most, const Axis& axis);
  void fit_logarithmic(double least, double most, bool zero);

  std::vector<double> ticks_;
  bool logarithmic_ = false;
  bool zero_ = false;  ///< on a logarithmic axis
  double low_ = 0;     ///< in what is linear along the axis: the value or its logarithm
  double high_ = 1;
  double begin_;
  double end_;
};

/// Finite, and neither so large nor so small that its axis would leave binary64.
bool can_be_drawn(double value);

/// A number of an axis: short, with k, M and G for thousands, millions and billions.
std::string tick_text(double value);

}  // namespace cbvh::testbench
