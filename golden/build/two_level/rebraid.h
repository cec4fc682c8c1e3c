// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <span>

#include "golden/build/two_level/opening_rule.h"
#include "golden/build/two_level/top_level.h"

namespace cbvh::golden {

/// A top level by binned SAH over whole instances, each weighed with its primitives.
TopLevelKind plain_top_level();

/// The re-braided top level of Benthin et al. (2017): the same, but before a segment is split the references that are
/// wide are opened, as long as different instances overlap and the segment's share of the array lasts.
TopLevelKind rebraid_top_level();

/// Part of the array of references: [first, last) are references, [last, end) is space for more (section 5.2).
struct Segment {
  std::uint32_t first;
  std::uint32_t last;
  std::uint32_t end;
  std::uint32_t node;  ///< where its node goes
  int levels;          ///< of inner nodes that may still follow
  bool opening;
  WideBox bounds;  ///< of its references, before any is opened; while it is `opening`

  std::uint32_t count() const { return last - first; }
  std::uint32_t space() const { return end - last; }
};

/// Sees every segment and its references before they are opened; from any thread.
using SegmentObserver = std::function<void(const Segment& segment, std::span<const BuildReference> references)>;

struct RebraidOptions {
  OpeningRule rule;
  std::uint32_t width = 2;
  bool open_leaves = false;
  int bins = 16;
  int depth = 32;
  int threads = 1;
  std::uint64_t places = 0;  ///< of the array; not below the number of instances: no opening if equal
};

/// Throws InputError when the depth cannot hold the instances. Deterministic: threads change nothing.
TopLevel build_rebraided(const InstancedTrees& trees, const RebraidOptions& options,
                         const SegmentObserver& observer = {});

}  // namespace cbvh::golden
