// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec3.hpp>
#include <string>

#include "golden/trace/ray.h"

namespace cbvh::golden {

/// A pinhole camera.
class Camera {
 public:
  /// Looks from `eye` at `target`; the image's upper edge lies towards `up`. `half_height` is half the image's height
  /// at distance 1. Throws InputError at `place` unless all are finite, eye and target differ, up is not along the line
  /// between them and half_height is above 0.
  Camera(const std::string& place, const glm::dvec3& eye, const glm::dvec3& target, const glm::dvec3& up,
         double half_height);

  /// From above and beside a box, at a distance from which all of it is seen.
  static Camera around(const Box& box);

  /// From within a box, close to one end of its longest side, towards the other end.
  static Camera inside(const Box& box);

  /// Through the middle of a pixel; (0, 0) is the upper left one. In the image's middle the direction has length 1.
  Ray ray(unsigned x, unsigned y, unsigned width, unsigned height) const;

 private:
  glm::dvec3 eye_;
  glm::dvec3 forward_;
  glm::dvec3 right_;  ///< as long as half the image's height is
  glm::dvec3 up_;
};

}  // namespace cbvh::golden
