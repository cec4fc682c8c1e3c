// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "golden/scene/mesh.h"
#include "golden/trace/ray.h"

namespace cbvh::testbench {

/// Rays that are made, not those of a picture.
enum class RaySet : std::uint8_t {
  incoherent,     ///< from anywhere in and around the scene, in any direction
  axis_parallel,  ///< two components of the direction are zero, of either sign; half of them through a vertex
  edges,          ///< at a point of a triangle's edge, as well as binary32 can
  vertices,       ///< at a vertex
};
inline constexpr std::array<const char*, 4> kRaySetNames = {"incoherent", "axis-parallel", "edges", "vertices"};

/// A ray of a set. Depends on the seed and the numbers alone.
golden::Ray made_ray(RaySet set, const golden::Mesh& mesh, const golden::Box& box, std::uint64_t seed,
                     std::uint64_t number);

}  // namespace cbvh::testbench
