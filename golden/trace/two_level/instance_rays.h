// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/mat3x3.hpp>
#include <vector>

#include "golden/scene/instances.h"
#include "golden/trace/ray.h"

namespace cbvh::golden {

/// Rays in the spaces of a scene's instances (Bikker, part 6: the ray is transformed, and its direction keeps the
/// length it gets, so that t means the same in the world). In binary64.
///
/// An image is not exact: mapped back to the world it lies beside its ray. But what it hits inside of an instance has
/// to be inside of every world box around that, or a top level could miss it. Let A, T be an instance's matrix and
/// translation, N the computed inverse of A, |M| a matrix of magnitudes, u = 2^-53, all norms the largest row. Image
/// and ray are apart by at most (|A N - I| + 5u |A||N|) times the distance from the instance's origin T; a hit is
/// outside of its triangle's box by at most 2^-49 of its distance from it (PreparedRay); and the hit's distance from
/// the ray's origin is at most that of the instance. With r the norm of |A N - I| + 2^-48 |A||N| and R a bound on all
/// coordinates in the world, all of it is together at most 2 r (2 |origin| + 3 R) as long as r <= 1/2. Twice that
/// leaves room for the rounding of the box tests.
class InstanceRays {
 public:
  /// Of a scene that check_scene accepts.
  explicit InstanceRays(const TwoLevelScene& scene);

  WideRay image(const Ray& ray, std::uint32_t instance) const;

  /// By how much a box of a top level has to be wider on every side, for that ray. Infinite if an inverse is not good
  /// enough to say.
  double slack(const Ray& ray) const;

 private:
  struct Inverse {
    glm::dmat3 linear;
    glm::dvec3 translation;  ///< of the instance, not inverted
  };
  std::vector<Inverse> inverses_;
  double error_ = 0;  ///< the largest r
  double reach_ = 0;  ///< R
};

}  // namespace cbvh::golden
