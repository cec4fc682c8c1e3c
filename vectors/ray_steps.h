// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_model/datapath/ray_job_payloads.h"

/// Stimuli and responses of the traversal unit.
namespace cbvh::vectors {

/// What a primitive does to a ray that meets it as a candidate; the others it misses.
struct RayHit {
  rtl::UInt<rtl::kRayNumberBits> number;
  rtl::Pointer primitive;
  rtl::Float32 t;
  rtl::UInt<1> stop;
  static constexpr auto fields() {
    return rtl::field_list("number", &RayHit::number, "primitive", &RayHit::primitive, "t", &RayHit::t, "stop",
                           &RayHit::stop);
  }
  bool operator==(const RayHit&) const = default;
};

/// A step of an episode: memory and hits, as all steps together leave them, the tree, of which there is one, and rays.
template <int N>
struct TraversalStep {
  enum class Kind : std::uint8_t { memory, tree, hit, ray };
  rtl::UInt<2> kind;
  rtl::LineAddress line;
  rtl::LineWords words;
  rtl::RayTree<N> tree;
  RayHit hit;
  rtl::RayJob ray;
  static constexpr auto fields() {
    return rtl::field_list("kind", &TraversalStep::kind, "line", &TraversalStep::line, "words", &TraversalStep::words,
                           "tree", &TraversalStep::tree, "hit", &TraversalStep::hit, "ray", &TraversalStep::ray);
  }
  bool operator==(const TraversalStep&) const = default;
};

/// What became of the rays, one ray after the other: its candidates, whose slots are left out, then its report.
struct TraversalEvent {
  rtl::UInt<1> ends;
  rtl::RayCandidate candidate;
  rtl::RayReport report;
  static constexpr auto fields() {
    return rtl::field_list("ends", &TraversalEvent::ends, "candidate", &TraversalEvent::candidate, "report",
                           &TraversalEvent::report);
  }
  bool operator==(const TraversalEvent&) const = default;
};

}  // namespace cbvh::vectors
