// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <queue>
#include <vector>

#include "golden/build/build_limits.h"
#include "golden/build/piece.h"

namespace cbvh::golden {

/// Divides pieces as long as they are too large, those of the largest measure first, until there are `most`. Of equals
/// the one that came first. `Shard` has a measure and a piece; halves_of(shard) gives its parts.
template <class Shard, class HalvesOf>
std::vector<Piece> divide_largest(std::vector<Shard> shards, double too_large, std::uint64_t most,
                                  const HalvesOf& halves_of) {
  const auto later = [&](std::size_t a, std::size_t b) {
    return shards[a].measure < shards[b].measure || (shards[a].measure == shards[b].measure && a > b);
  };
  std::priority_queue<std::size_t, std::vector<std::size_t>, decltype(later)> waiting(later);
  const auto wait = [&](std::size_t i) {
    if (shards[i].measure > too_large) waiting.push(i);
  };
  for (std::size_t i = 0; i < shards.size(); ++i) wait(i);
  while (!waiting.empty() && shards.size() < most) {
    const std::size_t i = waiting.top();
    waiting.pop();
    std::vector<Shard> halves = halves_of(shards[i]);
    if (halves.empty()) continue;
    for (std::size_t k = 1; k < halves.size(); ++k) {
      shards.push_back(halves[k]);
      wait(shards.size() - 1);
    }
    shards[i] = halves[0];
    wait(i);
  }
  std::vector<Piece> pieces;
  pieces.reserve(shards.size());
  for (const Shard& shard : shards) pieces.push_back(shard.piece);
  std::stable_sort(pieces.begin(), pieces.end(), [](const Piece& a, const Piece& b) { return a.id < b.id; });
  return pieces;
}

/// The sweep's tree over pieces that divide_largest left. A leaf that holds several of one triangle names it once.
FloatTree sweep_pieces(const std::vector<Piece>& pieces, const Mesh& mesh, const OptionValues& options);

}  // namespace cbvh::golden
