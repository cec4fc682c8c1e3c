// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "golden/build/two_level/top_level.h"

namespace cbvh::golden {

/// Two positions of the list of what is not paired yet: the pair takes the place of `a`, the last of the list the place
/// of `b`.
struct Pairing {
  std::uint32_t a;
  std::uint32_t b;
  bool operator==(const Pairing&) const = default;
};

enum class PairSearch : std::uint8_t { scan, tree };

/// Agglomerative clustering of at least one box (Bikker, part 6, after Walter et al. 2008): from a box to its nearest
/// and on, until two are each other's nearest; they are paired, and the search goes on from the pair. One correction:
/// where the pair itself is the last of the list, it moves to the place of `b`, and the search goes on from there; as
/// printed, the search would pair it with itself. Both searches give the same.
std::vector<Pairing> nearest_pairings(std::span<const Box> boxes, PairSearch search);

/// The top level over whole instances that those pairings make. Its depth follows from the boxes alone.
TopLevelKind agglomerative_top_level();

}  // namespace cbvh::golden
