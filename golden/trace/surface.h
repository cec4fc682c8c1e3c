// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <optional>

#include "golden/trace/ray.h"

namespace cbvh::golden {

/// How much of the light a surface reflects; all are alike.
inline constexpr double kAlbedo = 0.75;

/// What secondary rays need to know of a scene.
struct SceneScale {
  double diagonal;
  double offset;  ///< how far from a surface its secondary rays start: some units in the last place of a coordinate
};
SceneScale scene_scale(const Box& box);

/// Where a ray has hit.
struct Surface {
  glm::dvec3 point;
  glm::dvec3 normal;  ///< of length 1, to the side the ray came from
};

/// Of a triangle hit at t; nothing on one without area.
std::optional<Surface> surface_of(const std::array<glm::dvec3, 3>& corners, const Ray& ray, double t);

/// The cosine between normal and viewer, 0..1.
double facing(const Surface& surface, const Ray& ray);

/// A ray that starts a little above the surface, so that it does not hit it again.
Ray leaving(const Surface& surface, const glm::dvec3& direction, const SceneScale& scale);

/// Whether a float holds its origin: coordinates close to the largest float may leave no room for the offset.
bool can_leave(const Ray& ray);

/// Light from a direction of length 1, 0..1: most from above.
double sky(const glm::dvec3& direction);

}  // namespace cbvh::golden
