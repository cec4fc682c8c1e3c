// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/trace/camera.h"

#include <glm/geometric.hpp>

#include "golden/input_error.h"

namespace cbvh::golden {
namespace {

bool is_finite(const glm::dvec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

}  // namespace

Camera::Camera(const std::string& place, const glm::dvec3& eye, const glm::dvec3& target, const glm::dvec3& up,
               double half_height)
    : eye_(eye), forward_(target - eye), right_(glm::cross(forward_, up)), up_(glm::cross(right_, forward_)) {
  if (!is_finite(eye) || !is_finite(target) || !is_finite(up)) throw InputError(place, "camera: want finite numbers");
  const bool open = half_height > 0 && std::isfinite(half_height);
  if (!open) throw InputError(place, fmt::format("camera: half height {}, want it above 0", half_height));
  const double distance = glm::length(forward_);
  const double width = glm::length(right_);
  const bool oriented = distance > 0 && std::isfinite(distance) && width > 0 && std::isfinite(width);
  if (!oriented) throw InputError(place, "camera: want an eye beside its target, and up beside the line between them");
  forward_ /= distance;
  right_ *= half_height / width;
  up_ *= half_height / glm::length(up_);
}

Camera Camera::around(const Box& box) {
  const glm::dvec3 lower(box.lower);
  const glm::dvec3 upper(box.upper);
  const double size = std::max(glm::length(upper - lower), 1e-30);
  const glm::dvec3 middle = (lower + upper) * 0.5;
  return {"camera", middle + glm::dvec3(1, 0.7, 2) * (size * 0.55), middle, glm::dvec3(0, 1, 0), 0.5};
}

Camera Camera::inside(const Box& box) {
  const glm::dvec3 extent = glm::dvec3(box.upper) - glm::dvec3(box.lower);
  const glm::dvec3 middle = glm::dvec3(box.lower) + extent * 0.5;
  const int longest = extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
  glm::dvec3 along(0);
  along[longest] = std::max(extent[longest], 1e-30) * 0.4;
  return {"camera", middle - along, middle, longest == 1 ? glm::dvec3(0, 0, 1) : glm::dvec3(0, 1, 0), 0.7};
}

Ray Camera::ray(unsigned x, unsigned y, unsigned width, unsigned height) const {
  const double across = (2.0 * x + 1 - width) / height;
  const double upwards = (height - 2.0 * y - 1) / height;
  return {glm::vec3(eye_), glm::vec3(forward_ + right_ * across + up_ * upwards)};
}

}  // namespace cbvh::golden
