// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/trace/two_level/instance_rays.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/matrix.hpp>

namespace cbvh::golden {
namespace {

double largest(const glm::dvec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

glm::dmat3 magnitudes(const glm::dmat3& m) { return {glm::abs(m[0]), glm::abs(m[1]), glm::abs(m[2])}; }

/// The largest sum of a row's magnitudes.
double norm(const glm::dmat3& m) { return largest(magnitudes(m) * glm::dvec3(1)); }

glm::dvec3 largest_coordinates(const Mesh& mesh) {
  glm::vec3 most(0);
  for (const glm::vec3& position : mesh.positions) most = glm::max(most, glm::abs(position));
  return most;
}

}  // namespace

InstanceRays::InstanceRays(const TwoLevelScene& scene) {
  std::vector<glm::dvec3> most;
  for (const Mesh& object : scene.objects) most.push_back(largest_coordinates(object));
  inverses_.reserve(scene.instances.size());
  for (const Instance& instance : scene.instances) {
    const glm::dmat3 linear{glm::mat3(instance.to_world)};
    const glm::dvec3 translation(instance.to_world[3]);
    inverses_.push_back({glm::dmat3(inverse_of(instance.to_world, scene.name)), translation});
    const glm::dmat3& inverse = inverses_.back().linear;
    const glm::dmat3 residual = linear * inverse - glm::dmat3(1);
    const double error = norm(magnitudes(residual) + magnitudes(linear) * magnitudes(inverse) * 0x1p-48);
    error_ = std::max(error_, error);
    reach_ = std::max(reach_, largest(translation) + largest(magnitudes(linear) * most[instance.object]));
  }
}

WideRay InstanceRays::image(const Ray& ray, std::uint32_t instance) const {
  const Inverse& inverse = inverses_[instance];
  return {inverse.linear * (glm::dvec3(ray.origin) - inverse.translation), inverse.linear * glm::dvec3(ray.direction),
          static_cast<double>(ray.t_min), static_cast<double>(ray.t_max)};
}

double InstanceRays::slack(const Ray& ray) const {
  if (!(error_ <= 0.5)) return std::numeric_limits<double>::infinity();
  return 4 * error_ * (2 * largest(glm::dvec3(ray.origin)) + 3 * reach_);
}

}  // namespace cbvh::golden
