// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "golden/tree/node_pair_format.h"
#include "vectors/generate/ray_episodes.h"
#include "vectors/ray_tree.h"

namespace cbvh::vectors {

/// Memory, tree, hits and rays, in this order.
template <int N>
std::vector<TraversalStep<N>> ray_steps(const RayEpisode& episode) {
  using Step = TraversalStep<N>;
  std::vector<Step> steps;
  const auto add = [&](typename Step::Kind kind) -> Step& {
    steps.emplace_back().kind = rtl::UInt<2>(static_cast<std::uint64_t>(kind));
    return steps.back();
  };
  const auto put = [&](std::uint64_t first_line, const std::vector<std::uint32_t>& words) {
    for (std::size_t i = 0; i < words.size(); i += rtl::kWordsPerLine) {
      Step& step = add(Step::Kind::memory);
      step.line = rtl::LineAddress(first_line + i / rtl::kWordsPerLine);
      const std::size_t end = std::min(i + rtl::kWordsPerLine, words.size());
      for (std::size_t j = i; j < end; ++j) step.words[j - i] = rtl::UInt<32>(words[j]);
    }
  };
  std::vector<std::uint32_t> words;
  for (const golden::CompressedPair& pair : episode.tree.pairs) {
    for (const std::uint64_t word : golden::pack_node_pair(pair)) {
      words.push_back(static_cast<std::uint32_t>(word));
      words.push_back(static_cast<std::uint32_t>(word >> 32));
    }
  }
  put(kRayPairs, words);
  put(kRayIds, episode.tree.primitive_ids);
  add(Step::Kind::tree).tree = ray_tree<N>(episode.tree, kRayPairs, kRayIds);
  for (const RayHit& hit : episode.hits) add(Step::Kind::hit).hit = hit;
  for (const rtl::RayJob& ray : episode.rays) add(Step::Kind::ray).ray = ray;
  return steps;
}

}  // namespace cbvh::vectors
