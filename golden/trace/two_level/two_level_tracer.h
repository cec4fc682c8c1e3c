// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "golden/build/two_level/top_level.h"
#include "golden/trace/traverse.h"
#include "golden/trace/two_level/instance_rays.h"
#include "golden/trace/two_level/object_view.h"

namespace cbvh::golden {

/// The nearest hit among all instances. Of those at the same t the one of the least instance, of that the one of the
/// least triangle, so that it does not depend on the trees.
struct InstanceHit {
  static constexpr std::uint32_t kNone = Hit::kNone;
  std::uint32_t instance = kNone;
  std::uint32_t primitive = kNone;  ///< of the instance's object
  double t = std::numeric_limits<double>::infinity();
  bool operator==(const InstanceHit&) const = default;

  /// Whether it is the nearer one, or the one of equals that counts.
  bool before(const InstanceHit& other) const {
    if (t != other.t) return t < other.t;
    return instance != other.instance ? instance < other.instance : primitive < other.primitive;
  }
};

struct TwoLevelCounts {
  TraceCounts top;
  TraceCounts objects;
  std::uint64_t transforms = 0;  ///< rays taken into the space of an instance: references reached
  void add(const TwoLevelCounts& other) {
    top.add(other.top);
    objects.add(other.objects);
    transforms += other.transforms;
  }
  bool operator==(const TwoLevelCounts&) const = default;
};

/// Traces rays through a top level and the objects below it. Keeps its stacks between rays; one a thread.
class TwoLevelTracer {
 public:
  /// All of them of the same scene, which check_scene accepts.
  TwoLevelTracer(const TopLevel& top, const InstancedTrees& trees, const InstanceRays& rays);

  /// The nearest hit in [t_min, t_max], the first found with Stop::any. The ray must pass check_ray. What counts as a
  /// hit is decided in the space of the instance, where no ray passes between triangles that share an edge.
  InstanceHit trace(const Ray& ray, Stop stop);

  TwoLevelCounts counts() const;

 private:
  struct Waiting {
    std::uint32_t pair;
    double entry;
  };
  /// What lies below a leaf's reference; true if the ray is done.
  bool enter(std::uint32_t entry, const Ray& ray, Stop stop, InstanceHit& nearest);

  const TopLevel& top_;
  const InstancedTrees& trees_;
  const InstanceRays& rays_;
  std::vector<Tracer<ObjectTreeView>> objects_;
  std::vector<Waiting> waiting_;
  TraceCounts counts_;
  std::uint64_t transforms_ = 0;
};

}  // namespace cbvh::golden
