// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>

#include "golden/trace/surface.h"
#include "golden/trace/traverse.h"

namespace cbvh::golden {

/// A mesh behind one of its trees, as pixels see it.
template <class View>
class TracedMesh {
 public:
  using Hit = golden::Hit;

  TracedMesh(const View& view, const Mesh& mesh) : tracer_(view, mesh), mesh_(&mesh), box_(view.root_box()) {}

  const Box& box() const { return box_; }
  Hit trace(const Ray& ray, Stop stop) { return tracer_.trace(ray, stop); }
  const TraceCounts& counts() const { return tracer_.counts(); }

  /// Nothing without a hit, or on a triangle without area.
  std::optional<Surface> surface(const Ray& ray, const Hit& hit) const {
    if (hit.primitive == Hit::kNone) return std::nullopt;
    const glm::uvec3& triangle = mesh_->triangles[hit.primitive];
    const auto corner = [&](int i) { return glm::dvec3(mesh_->positions[triangle[i]]); };
    return surface_of({corner(0), corner(1), corner(2)}, ray, hit.t);
  }

 private:
  Tracer<View> tracer_;
  const Mesh* mesh_;
  Box box_;
};

}  // namespace cbvh::golden
