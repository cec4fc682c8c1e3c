// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "golden/trace/surface.h"
#include "golden/trace/two_level/two_level_tracer.h"

namespace cbvh::golden {

/// A scene of instances behind one top level and one kind of object trees, as pixels see it.
class TracedInstances {
 public:
  using Hit = InstanceHit;

  /// `box`: around all instances. What is referred to stays with the caller.
  TracedInstances(const TopLevel& top, const InstancedTrees& trees, const InstanceRays& rays, const Box& box)
      : tracer_(top, trees, rays), scene_(trees.scene), box_(box) {}

  const Box& box() const { return box_; }
  InstanceHit trace(const Ray& ray, Stop stop) { return tracer_.trace(ray, stop); }

  /// On both levels together.
  TraceCounts counts() const;

  /// Nothing without a hit, or on a triangle without area.
  std::optional<Surface> surface(const Ray& ray, const InstanceHit& hit) const;

 private:
  TwoLevelTracer tracer_;
  const TwoLevelScene* scene_;
  Box box_;
};

}  // namespace cbvh::golden
