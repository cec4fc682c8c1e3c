// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include "golden/build/build_limits.h"
#include "golden/build/piece.h"

namespace cbvh::golden {

/// Moves the pieces whose centroids lie below the middle of all centroids, on their longest axis, to the front; returns
/// how many. 0 if nothing tells them apart.
std::uint32_t split_in_middle(std::span<Piece> pieces);

/// The expected cost of a tree of such splits (paper 001, section 3.4: what a configuration's subtrees are weighed by)
/// times its root's half area. A node is a leaf where that is allowed and cheaper. Reorders the pieces.
double middle_split_cost(std::span<Piece> pieces, const BuildLimits& limits);

}  // namespace cbvh::golden
