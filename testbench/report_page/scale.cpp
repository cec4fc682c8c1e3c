// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/report_page/scale.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace cbvh::testbench {

namespace {

constexpr double kZeroBand = 0.12;  ///< of a logarithmic axis, between 0 and its least power
constexpr double kMostTicks = 7;
constexpr double kFewDecades = 1.7;  ///< up to these, an axis has 1, 2 and 5 of each

constexpr double kSameValue = 1e-9;  ///< values this close, relative to them, stand at one place
constexpr double kSmallest = 1e-200;
constexpr double kLargest = 1e200;

/// The least of 1, 2 and 5 times a power of ten that is not below `value`.
double step_of(double value) {
  const double power = std::pow(10, std::floor(std::log10(value)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= value * (1 - 1e-9)) return factor * power;
  }
  return 10 * power;
}

}  // namespace

Scale::Scale(const Axis& axis, const std::vector<double>& values, double begin, double end) : begin_(begin), end_(end) {
  if (values.empty()) {
    fit_linear(0, 1, axis);
    return;
  }
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  double least_positive = *most;
  for (const double value : values) {
    if (value > 0) least_positive = std::min(least_positive, value);
  }
  if (axis.logarithmic && *least >= 0 && *most > 0) {
    fit_logarithmic(least_positive, *most, *least == 0);
  } else {
    fit_linear(*least, *most, axis);
  }
}

void Scale::fit_linear(double least, double most, const Axis& axis) {
  if (axis.from_zero) {
    least = std::min(least, 0.0);
    most = std::max(most, 0.0);
  }
  if (most - least <= kSameValue * std::max(std::abs(least), std::abs(most))) {
    const double margin = least == 0 ? 1 : std::abs(least) / 2;
    most += margin;
    if (!axis.from_zero || least != 0) least -= margin;
  }
  const double finest = axis.whole ? 1 : 0;
  const double step = step_of(std::max((most - least) / (kMostTicks - 1), finest));
  const double first = std::floor(least / step + 1e-9);
  const double last = std::ceil(most / step - 1e-9);
  for (double i = first; i <= last; ++i) ticks_.push_back(i * step);
  low_ = first * step;
  high_ = last * step;
}

void Scale::fit_logarithmic(double least, double most, bool zero) {
  logarithmic_ = true;
  zero_ = zero;
  const bool fine = std::log10(most / least) <= kFewDecades;
  const int first = static_cast<int>(std::floor(std::log10(least) + 1e-9));
  const int last = static_cast<int>(std::ceil(std::log10(most) - 1e-9));
  std::vector<double> marks;
  for (int power = first; power <= std::max(last, first + 1); ++power) {
    for (const double factor : {1.0, 2.0, 5.0}) {
      if (factor == 1 || fine) marks.push_back(factor * std::pow(10, power));
    }
  }
  // The closest marks around all values; at least two.
  auto begin = std::upper_bound(marks.begin(), marks.end(), least * (1 + 1e-9));
  if (begin != marks.begin()) --begin;
  auto end = std::lower_bound(begin + 1, marks.end() - 1, most * (1 - 1e-9));
  low_ = std::log10(*begin);
  high_ = std::log10(*end);
  const auto stride = static_cast<std::ptrdiff_t>(std::ceil(static_cast<double>(end - begin) / kMostTicks));
  if (zero) ticks_.push_back(0);
  for (; begin < end; begin += std::min(stride, end - begin)) ticks_.push_back(*begin);
  ticks_.push_back(*end);
}

double Scale::place(double value) const {
  if (!logarithmic_) return begin_ + (value - low_) / (high_ - low_) * (end_ - begin_);
  if (value <= 0) return begin_;
  const double share = (std::log10(value) - low_) / (high_ - low_);
  return begin_ + (zero_ ? kZeroBand + (1 - kZeroBand) * share : share) * (end_ - begin_);
}

bool can_be_drawn(double value) {
  const double size = std::abs(value);
  return size == 0 || (size >= kSmallest && size <= kLargest);
}

std::string tick_text(double value) {
  const double size = std::abs(value);
  if (size >= 1e9) return fmt::format("{:.4g}G", value / 1e9);
  if (size >= 1e6) return fmt::format("{:.4g}M", value / 1e6);
  if (size >= 1e4) return fmt::format("{:.4g}k", value / 1e3);
  if (size < 1e-12) return "0";
  return fmt::format("{:.4g}", value);
}

}  // namespace cbvh::testbench
