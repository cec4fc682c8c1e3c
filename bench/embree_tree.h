// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <embree3/rtcore.h>
#include <embree3/rtcore_builder.h>

#include <vector>

#include "golden/scene/mesh.h"
#include "golden/tree/sah.h"

namespace cbvh::bench {

/// Embree, with so many threads, as a builder of binary trees.
class Embree {
 public:
  explicit Embree(int threads);
  ~Embree();
  Embree(const Embree&) = delete;
  Embree& operator=(const Embree&) = delete;

  /// The boxes of a mesh's triangles, then rtcBuildBVH: two children a node, leaves of at most `leaf` triangles. HIGH
  /// splits triangles' boxes where it wants to.
  struct Tree {
    double seconds;  ///< of both
    double sah;      ///< over the tightest boxes, as golden::sah counts
    std::size_t references;
  };
  Tree build(const golden::Mesh& mesh, RTCBuildQuality quality, unsigned leaf, const golden::SahCosts& costs) const;

  /// Seconds of rtcCommitScene of the mesh, its own tree and triangle format.
  double commit(const golden::Mesh& mesh, RTCBuildQuality quality) const;

 private:
  RTCDevice device_;
};

}  // namespace cbvh::bench
