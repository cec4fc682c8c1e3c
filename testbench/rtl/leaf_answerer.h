// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "rtl_model/datapath/ray_job_payloads.h"
#include "testbench/rtl/ports.h"

namespace cbvh::testbench {

/// Stands for the triangle unit beside a traversal unit: intersects the candidates of a leaf, notes them, and answers
/// for the leaf after its last one. intersect(candidate) gives what that one does to its ray: an rtl::LeafReply. Leaves
/// of several rays may come mixed.
template <class Intersect>
class LeafAnswerer {
 public:
  LeafAnswerer(rtl::Channel<rtl::RayCandidate>& candidates, rtl::Channel<rtl::LeafReply>& replies, Intersect intersect,
               SinkStalls stalls)
      : candidates_(candidates), replies_(replies), intersect_(intersect), stalls_(stalls) {}

  void tick() {
    if (stalls_.stalls() || !candidates_.can_pop() || !replies_.can_push()) return;
    const rtl::RayCandidate& candidate = candidates_.pop();
    met.push_back(candidate);
    Leaf& leaf = leaves_[candidate.slot.value()];
    const rtl::LeafReply found = intersect_(candidate);
    if (found.t.value() < leaf.t) leaf.t = found.t.value();
    leaf.stop = leaf.stop || bool(found.stop);
    if (!candidate.last_of_leaf) return;
    replies_.push({candidate.slot, rtl::Float32::of(leaf.t), rtl::UInt<1>(leaf.stop)});
    leaf = Leaf();
  }
  void commit(rtl::CommitKey) {}

  std::vector<rtl::RayCandidate> met;

 private:
  struct Leaf {
    float t = std::numeric_limits<float>::infinity();
    bool stop = false;
  };
  rtl::Channel<rtl::RayCandidate>& candidates_;
  rtl::Channel<rtl::LeafReply>& replies_;
  Intersect intersect_;
  SinkStalls stalls_;
  std::array<Leaf, std::size_t{1} << rtl::kRaySlotBits> leaves_{};
};

}  // namespace cbvh::testbench
