// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "golden/scene/mesh.h"
#include "golden/trace/traverse.h"
#include "testbench/trace/embree/embree_scene.h"

namespace cbvh::testbench {

/// What our nearest hit and Embree's are to each other. Exact is what golden::exact_hit says.
enum class HitRelation : std::uint8_t {
  nothing,          ///< neither hits
  same,             ///< the same triangle
  equal_distance,   ///< two triangles, exactly at the same distance: on an edge they share, or one in the other
  embree_rounds,    ///< ours is hit exactly; Embree has a farther one, one that is not hit, or none
  distance_rounds,  ///< Embree's is exactly nearer, but by less than our distances round: rounded, ours is not farther
  lost,             ///< Embree's is hit exactly, and nearer than ours or without one of ours
  not_hit,          ///< ours is not hit exactly
  wrong_distance,   ///< the same triangle, but Embree's distance in binary32 is nearer to the exact one than ours
};
inline constexpr std::size_t kHitRelations = 8;
inline constexpr std::array<const char*, kHitRelations> kHitRelationNames = {
    "nothing", "same", "equal_distance", "embree_rounds", "distance_rounds", "lost", "not_hit", "wrong_distance"};

/// Whether it is our mistake.
inline bool is_mistake(HitRelation relation) { return relation >= HitRelation::lost; }

HitRelation compare_hit(const golden::Mesh& mesh, const golden::Ray& ray, const golden::Hit& ours,
                        const EmbreeHit& embree);

}  // namespace cbvh::testbench
