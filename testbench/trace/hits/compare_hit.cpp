// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/trace/hits/compare_hit.h"

#include <cmath>

#include "golden/trace/exact_triangle.h"

namespace cbvh::testbench {

namespace {

using golden::ExactDistance;
using golden::Hit;

/// Differences of binary32 below this are not looked into: both distances are right.
constexpr double kPlausible = 0x1p-18;

std::array<glm::vec3, 3> corners(const golden::Mesh& mesh, std::uint32_t primitive) {
  const glm::uvec3& triangle = mesh.triangles[primitive];
  return {mesh.positions[triangle.x], mesh.positions[triangle.y], mesh.positions[triangle.z]};
}

std::optional<ExactDistance> exact(const golden::Mesh& mesh, const golden::Ray& ray, std::uint32_t primitive) {
  if (primitive == Hit::kNone) return std::nullopt;
  const auto [a, b, c] = corners(mesh, primitive);
  return golden::exact_hit(ray, a, b, c);
}

/// Whether our own test takes the triangle, and before our hit: then the traversal lost it.
bool takes_before(const golden::Mesh& mesh, const golden::Ray& ray, std::uint32_t primitive, const Hit& ours) {
  golden::FloatTree none;
  golden::Tracer tracer{golden::FloatTreeView(none), mesh};
  Hit hit = ours;
  return tracer.test_triangle(primitive, golden::PreparedRay(ray), golden::TriangleTest(ray), hit);
}

HitRelation compare_distance(const golden::Mesh& mesh, const golden::Ray& ray, const Hit& ours, float embree) {
  if (std::abs(ours.t - static_cast<double>(embree)) <= kPlausible * std::abs(ours.t)) return HitRelation::same;
  const std::optional<ExactDistance> t = exact(mesh, ray, ours.primitive);
  if (!t) return HitRelation::not_hit;
  const int order =
      golden::compare(golden::distance_between(*t, ours.t), golden::distance_between(*t, static_cast<double>(embree)));
  return order <= 0 ? HitRelation::same : HitRelation::wrong_distance;
}

}  // namespace

HitRelation compare_hit(const golden::Mesh& mesh, const golden::Ray& ray, const Hit& ours, const EmbreeHit& embree) {
  const bool none = ours.primitive == Hit::kNone;
  if (ours.primitive == embree.primitive)
    return none ? HitRelation::nothing : compare_distance(mesh, ray, ours, embree.t);
  const std::optional<ExactDistance> our_t = exact(mesh, ray, ours.primitive);
  const std::optional<ExactDistance> their_t = exact(mesh, ray, embree.primitive);
  if (!none && !our_t) return HitRelation::not_hit;
  if (!their_t) return HitRelation::embree_rounds;
  if (none) return HitRelation::lost;
  const int order = golden::compare(*our_t, *their_t);
  if (order == 0) return HitRelation::equal_distance;
  if (order < 0) return HitRelation::embree_rounds;
  return takes_before(mesh, ray, embree.primitive, ours) ? HitRelation::lost : HitRelation::distance_rounds;
}

}  // namespace cbvh::testbench
