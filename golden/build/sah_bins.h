// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
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
  explicit SahBins(int bins) : bins_(bins) { clear(); }

  void clear() {
    for (auto& bins : axes_) std::fill_n(bins.begin(), bins_, Bin{WideBox().lower, WideBox().upper, 0});
  }

  void add(Int4 bin, const WideBox& box, std::uint32_t weight) {
    axes_[0][static_cast<std::size_t>(bin[0])].add(box, weight);
    axes_[1][static_cast<std::size_t>(bin[1])].add(box, weight);
    axes_[2][static_cast<std::size_t>(bin[2])].add(box, weight);
  }

  /// As if all that was added to `other` had been added here. In any order: the result is the same.
  void merge(const SahBins& other);

  /// The weight before a split.
  std::uint32_t left(const Split& split) const;

  /// What lies before a split and what behind.
  std::array<WideBox, 2> boxes(const Split& split) const;

  /// The cheapest split between two bins; of equals the one with the lowest axis, then position. None if all lies in
  /// one bin of each axis.
  Split best() const;

 private:
  /// Trivial, so that those beyond the last one are never written.
  struct Bin {
    Float4 lower;
    Float4 upper;
    std::uint32_t weight;

    WideBox box() const { return {lower, upper}; }
    void add(const WideBox& box, std::uint32_t of_weight) {
      lower = lesser(lower, box.lower);
      upper = greater(upper, box.upper);
      weight += of_weight;
    }
  };
  int bins_;
  std::array<std::array<Bin, kMaxBins>, 3> axes_;
};

}  // namespace cbvh::golden
