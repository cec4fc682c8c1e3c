// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/build/middle_split.h"

#include <algorithm>

#include "golden/build/wide_box.h"

namespace cbvh::golden {
namespace {

double cost_of(std::span<Piece> pieces, const BuildLimits& limits, int levels) {
  const double area = half_area(box_of(pieces));
  const double as_leaf = limits.intersection * static_cast<double>(pieces.size()) * area;
  const std::uint32_t left = levels == 0 ? 0 : split_in_middle(pieces);
  if (left == 0) return as_leaf;
  const double split = limits.traversal * area + cost_of(pieces.first(left), limits, levels - 1) +
                       cost_of(pieces.subspan(left), limits, levels - 1);
  return pieces.size() <= limits.leaf ? std::min(as_leaf, split) : split;
}

}  // namespace

std::uint32_t split_in_middle(std::span<Piece> pieces) {
  WideBox centroids;
  for (const Piece& piece : pieces) centroids.enclose(widened(piece.box).centroid());
  const int axis = longest_axis(centroids);
  const float middle = centroids.centroid()[axis];
  const auto right = std::partition(pieces.begin(), pieces.end(),
                                    [&](const Piece& piece) { return widened(piece.box).centroid()[axis] < middle; });
  // Halves of subnormals round, so that the middle may lie above all centroids.
  return right == pieces.end() ? 0 : static_cast<std::uint32_t>(right - pieces.begin());
}

double middle_split_cost(std::span<Piece> pieces, const BuildLimits& limits) {
  return cost_of(pieces, limits, limits.depth);
}

}  // namespace cbvh::golden
