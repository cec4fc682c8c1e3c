// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "golden/build/wide_box.h"

namespace cbvh::golden {

/// The boxes that agglomerative clustering still has to pair, and which two belong together (Bikker, part 6:
/// FindBestMatch). Both searches answer the same, equal distances included.

/// As described there: every box that is left is looked at.
class ScanSearch {
 public:
  explicit ScanSearch(std::span<const Box> items);

  /// The position, other than `position`, whose box makes the smallest box (half area, binary64) with it; the first of
  /// several. There are at least two boxes.
  std::uint32_t best_match(std::uint32_t position) const;
  /// The box at `a` becomes the one around both; the last box takes b's place.
  void merge(std::uint32_t a, std::uint32_t b);

 private:
  std::vector<WideBox> boxes;
};

/// The same over a balanced tree of places that are sorted once: a node knows the largest lower and the smallest upper
/// corner below it, and with them a bound on every distance to what is below it.
class TreeSearch {
 public:
  explicit TreeSearch(std::span<const Box> items);

  std::uint32_t best_match(std::uint32_t position) const;
  void merge(std::uint32_t a, std::uint32_t b);

 private:
  void sort_places(std::span<std::uint32_t> items, std::uint32_t first_place, std::span<const Box> boxes,
                   std::uint32_t places);
  void update(std::uint32_t place);

  /// A heap: 1 is the root, 2i and 2i + 1 are below i, places are the nodes from `first_place` on. Of a place: its box;
  /// above: the corners said before. Where nothing is left both are infinite, and so is every bound.
  std::vector<WideBox> nodes;
  std::size_t first_place = 1;
  std::vector<std::uint32_t> place_of;     ///< by position
  std::vector<std::uint32_t> position_of;  ///< by place, from 0
};

}  // namespace cbvh::golden
