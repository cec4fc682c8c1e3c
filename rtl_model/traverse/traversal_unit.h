// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tuple>

#include "rtl_model/traverse/pair_intersector.h"
#include "rtl_model/traverse/ray_scheduler.h"
#include "rtl_model/traverse/ray_setter.h"

namespace cbvh::rtl {

/// The outside of a traversal unit.
struct TraversalPorts {
  Channel<RayJob>& rays;
  Channel<RayCandidate>& candidates;
  Channel<LeafReply>& replies;  ///< one for each candidate that is the last of its leaf
  Channel<RayReport>& reports;
  LinePort pairs;
  LinePort ids;
};

/// Rays through a compressed tree in memory, several at a time: their leaves' primitives as candidates to be
/// intersected outside, whose nearest hit comes back and shortens the ray, then a report. Rays overtake each other;
/// what is said of one ray, and in which order, does not depend on the others. A ray's step to the
/// next pair takes 11 clocks, or 12 and the memory's latency if the pair is not in the last line; all rays together
/// make up to one a clock. Paper sections 3 and 5.5.
template <class Bits, int N>
class TraversalUnit {
 public:
  TraversalUnit(const TraversalPorts& ports, const RayTree<N>& tree, std::size_t slots)
      : scheduler_({ports.rays, setups_, set_up_, tests_, tested_, ports.candidates, ports.replies, ports.reports,
                    ports.pairs, ports.ids},
                   tree, slots),
        setter_(setups_, set_up_),
        intersector_(tests_, tested_) {}

  auto parts() { return std::tie(scheduler_, setups_, setter_, set_up_, tests_, intersector_, tested_); }

  /// The channels between the parts (rtl_model/kernel/netlist.h).
  template <class Visit>
  void channels(Visit&& visit) const {
    visit("setups", "ray_scheduler", "ray_setter", setups_);
    visit("set_up", "ray_setter", "ray_scheduler", set_up_);
    visit("tests", "ray_scheduler", "pair_intersector", tests_);
    visit("tested", "pair_intersector", "ray_scheduler", tested_);
  }

 private:
  Channel<RaySetupJob> setups_;
  Channel<RaySetupResult> set_up_;
  Channel<PairTestJob<N>> tests_;
  Channel<PairTestResult<N>> tested_;
  RayScheduler<Bits, N> scheduler_;
  RaySetter<Bits> setter_;
  PairIntersector<Bits, N> intersector_;
};

}  // namespace cbvh::rtl
