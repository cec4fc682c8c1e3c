// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/trace/two_level/traced_instances.h"

namespace cbvh::golden {

TraceCounts TracedInstances::counts() const {
  const TwoLevelCounts both = tracer_.counts();
  TraceCounts sum = both.top;
  sum.add(both.objects);
  return sum;
}

std::optional<Surface> TracedInstances::surface(const Ray& ray, const InstanceHit& hit) const {
  if (hit.primitive == InstanceHit::kNone) return std::nullopt;
  const Instance& instance = scene_->instances[hit.instance];
  const Mesh& mesh = scene_->objects[instance.object];
  const glm::uvec3& triangle = mesh.triangles[hit.primitive];
  const glm::dmat4 to_world(instance.to_world);
  const auto corner = [&](int i) { return glm::dvec3(to_world * glm::dvec4(mesh.positions[triangle[i]], 1)); };
  return surface_of({corner(0), corner(1), corner(2)}, ray, hit.t);
}

}  // namespace cbvh::golden
