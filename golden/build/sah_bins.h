// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "golden/build/split.h"
#include "golden/build/wide_box.h"

namespace cbvh::golden {

inline constexpr int kMaxBins = 32;

/// Which bin a centroid projects to, on each axis (paper 002, section 4): `bins` bins of equal width across the
/// centroids' box.
class BinMapping {
 public:
  /// At least 1 bin; at most kMaxBins where SahBins are filled.
  BinMapping(const WideBox& centroids, int bins) : BinMapping(centroids, {bins, bins, bins}) {}
  BinMapping(const WideBox& centroids, const std::array<int, 3>& bins);

  /// In lanes 0..2: 0 .. bins - 1. An axis on which all centroids agree, or differ too little for binary32, has but
  /// one bin.
  Int4 bin_of(Float4 centroid) const {
    return __builtin_convertvector(lesser((centroid - lower_) * scale_, last_), Int4);
  }

 private:
  Float4 lower_;
  Float4 scale_;
  Float4 last_;
};

/// A histogram of anything with a box, a centroid and a weight (how many primitives it stands for), over bins of three
/// axes.
class SahBins {
 public:
  explicit SahBins(int bins) : bins_(bins) {}

  void add(Int4 bin, const WideBox& box, std::uint32_t weight) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      Bin& entry = axes_[axis][static_cast<std::size_t>(bin[axis])];
      entry.box.enclose(box);
      entry.weight += weight;
    }
  }

  /// As if all that was added to `other` had been added here. In any order: the result is the same.
  void merge(const SahBins& other);

  /// The weight before a split.
  std::uint32_t left(const Split& split) const;

  /// The cheapest split between two bins; of equals the one with the lowest axis, then position. None if all lies in
  /// one bin of each axis.
  Split best() const;

 private:
  struct Bin {
    WideBox box;
    std::uint32_t weight = 0;
  };
  int bins_;
  std::array<std::array<Bin, kMaxBins>, 3> axes_;
};

}  // namespace cbvh::golden
