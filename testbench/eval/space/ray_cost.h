// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "golden/trace/traverse.h"

namespace cbvh::testbench {

/// Which random rays, and when they stop.
enum class RandomRays : std::uint8_t {
  terminating,  ///< from anywhere in the scene's box, to the nearest hit (paper 001's Cost_ray with early termination)
  through,      ///< across the scene's box, never stopping: those whose expected cost the SAH is
};

struct RayCosts {
  golden::TraceCounts counts;
  std::vector<golden::Hit> hits;  ///< of each ray
};

/// Traces so many rays, the same ones through every tree of a mesh. Depends on the number of threads in nothing.
RayCosts trace_random_rays(const golden::FloatTree& tree, const golden::Mesh& mesh, RandomRays kind, std::uint64_t rays,
                           unsigned threads);

}  // namespace cbvh::testbench
