// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "golden/build/float_tree.h"
#include "golden/tree/compressed_tree.h"

namespace cbvh::golden {

/// What a streaming compression cost.
struct StreamingCounts {
  std::uint64_t backtracks = 0;  ///< node pairs re-encoded
  std::vector<std::uint64_t>
      depth_histogram;  ///< [d]: those d levels below the pair that had just arrived; [0] is always 0
  bool operator==(const StreamingCounts&) const = default;
};

/// Sees everything the stream writes, in order. One arrival finalises the pairs of its treelet's last level from left
/// to right: on_final of the pair, then the repairs below its child 0, then those below its child 1, then the next
/// pair. Repairs come depth first: a re-encoded pair's child 0 and all below it, then its child 1. After the last
/// arrival the pairs that are not final yet follow from the root downwards, depth first, parents before children
/// (pre-order); nothing is repaired there. Contexts are the pair's own grid: the one its codes are written on. Only for
/// scales at or above the exactness limit.
struct StreamingObserver {
  std::function<void(std::uint32_t index, const CompressedPair& pair, const Context<std::int64_t>& context)> on_final;
  std::function<void(std::uint32_t index, const CompressedPair& old_pair, const CompressedPair& new_pair,
                     const Context<std::int64_t>& old_context, const Context<std::int64_t>& new_context)>
      on_repair;
};

struct StreamingResult {
  CompressedTree tree;
  StreamingCounts counts;
};

/// The streaming compressor: pairs arrive in emission order, contexts are estimated, and what an estimate got wrong is
/// repaired (DESIGN section 3, rules 6 to 10; the paper's algorithm 1 and section 4.3). `treelet_levels` is D, 1..16.
/// The tree equals compress_top_down's bit for bit. Throws InputError for rules or D out of their domain, or an
/// observer below the exactness limit.
StreamingResult compress_streaming(const FloatTree& tree, const GridRules& rules, Code code, int treelet_levels,
                                   const StreamingObserver* observer = nullptr);

}  // namespace cbvh::golden
