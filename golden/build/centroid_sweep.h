// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "golden/build/object_median.h"
#include "golden/build/piece.h"
#include "golden/build/split.h"
#include "golden/build/wide_box.h"

namespace cbvh::golden {

/// Pieces by centroid; equal ones keep their order.
std::vector<Rank> by_centroid(std::span<const Piece> pieces, int axis);

/// Every split by centroids (paper 001, section 2.3) with its cost and its halves' boxes: by axis, then position.
void for_each_centroid(std::span<const Piece> pieces,
                       const std::function<void(const Split&, const WideBox& left, const WideBox& right)>& visit);

/// The cheapest of them, the first of equals.
Split best_centroid(std::span<const Piece> pieces);

}  // namespace cbvh::golden
