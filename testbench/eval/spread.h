// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <vector>

namespace cbvh::testbench {

/// The least, the greatest and the average of some figures.
struct Spread {
  double least;
  double most;
  double average;
};

/// `values` is not empty.
inline Spread spread_of(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  return {*least, *most, sum / static_cast<double>(values.size())};
}

inline double average(const std::vector<double>& values) { return spread_of(values).average; }

}  // namespace cbvh::testbench
