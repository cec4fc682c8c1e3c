// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "golden/build/two_level/top_level.h"
#include "golden/tree/sah.h"

namespace cbvh::golden {

/// The surface area heuristic of both levels together ("total SAH", Benthin et al., table 1), each area relative to
/// that of `world`: give the same box to compare top levels of one scene. A top level's nodes and the references below
/// it count with their world boxes; what lies below a reference with the surface of the parallelepiped that the
/// instance makes of its box, for that is what a random line hits. A world without area gives every node the relative
/// area 1.
double two_level_sah(const TopLevel& top, const InstancedTrees& trees, const Box& world, const SahCosts& costs = {});

/// The box around all whole instances, as a top level sees them.
Box world_of(const InstancedTrees& trees);

}  // namespace cbvh::golden
