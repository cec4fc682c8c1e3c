// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_model/datapath/ray_setup.h"
#include "rtl_model/kernel/channel.h"
#include "rtl_model/kernel/stage_pipeline.h"

namespace cbvh::rtl {

/// Directions to reciprocals, and the planes of the root's box to distances along the ray. Latency 32, of which a
/// divider has 26, initiation interval 1. Paper eq. 4.
template <class Bits>
struct RaySetter : StagePipeline<RaySetupJob, RaySetupResult, 32, ray_setup<Bits>> {
  using StagePipeline<RaySetupJob, RaySetupResult, 32, ray_setup<Bits>>::StagePipeline;
};

}  // namespace cbvh::rtl
