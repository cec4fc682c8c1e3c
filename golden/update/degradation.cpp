// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/update/degradation.h"

#include <cstddef>

namespace cbvh::golden {
namespace {

/// The surface of a pair's own box over those of its children; 0 where they have none.
double ratio_of(const FloatPair& pair) {
  const double children = half_area(pair.child[0]) + half_area(pair.child[1]);
  return children > 0 ? half_area(own_box(pair)) / children : 0;
}

}  // namespace

Degradation::Degradation(const FloatTree& built) {
  ratios_.reserve(built.pairs.size());
  for (const FloatPair& pair : built.pairs) ratios_.push_back(ratio_of(pair));
}

double Degradation::of(const FloatTree& refitted) const {
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < ratios_.size(); ++i) {
    const double now = ratio_of(refitted.pairs[i]);
    if (now == 0 || ratios_[i] == 0) continue;
    sum += now / ratios_[i];
    ++count;
  }
  return count == 0 ? 1 : sum / static_cast<double>(count);
}

}  // namespace cbvh::golden
