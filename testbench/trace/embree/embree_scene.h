// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>

#include "golden/scene/mesh.h"
#include "golden/trace/traverse.h"

namespace cbvh::testbench {

/// What Embree says of a ray.
struct EmbreeHit {
  std::uint32_t primitive = golden::Hit::kNone;
  float t = 0;  ///< of a hit
};

/// A mesh in Embree, with its own tree, on one thread.
class EmbreeScene {
 public:
  /// Robust: what Embree has against missed hits. Throws Unavailable in a build without Embree.
  EmbreeScene(const golden::Mesh& mesh, bool robust);
  EmbreeScene(const EmbreeScene&) = delete;
  EmbreeScene& operator=(const EmbreeScene&) = delete;
  ~EmbreeScene();

  /// The nearest hit (rtcIntersect1). Threads may call it together.
  EmbreeHit trace(const golden::Ray& ray) const;

 private:
  struct Handles;
  std::unique_ptr<Handles> handles_;
};

}  // namespace cbvh::testbench
