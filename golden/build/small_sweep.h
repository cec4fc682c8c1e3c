// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "golden/build/sah_bins.h"
#include "golden/build/wide_box.h"

namespace cbvh::golden {

/// The SAH at every centroid of three axes, as sweep.h, of a handful of references: cheaper than filling bins.
class SmallSweep {
 public:
  static constexpr std::size_t kMost = kMaxBins;

  /// 2 .. kMost references. Equal centroids keep their order.
  explicit SmallSweep(std::span<const Reference> references);

  const Split& best() const { return best_; }
  bool is_left(std::size_t index) const {
    return ranks_[index][best_.axis] < static_cast<std::int32_t>(best_.position);
  }

 private:
  std::array<Int4, kMost> ranks_;  ///< of each reference among the centroids on each axis
  Split best_;
};

}  // namespace cbvh::golden
