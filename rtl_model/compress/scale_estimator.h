// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_model/datapath/scale_estimate.h"
#include "rtl_model/kernel/channel.h"
#include "rtl_model/kernel/stage_pipeline.h"

namespace cbvh::rtl {

/// Estimates the grid of one axis of a node a clock, before its parent is known. Latency 3, initiation interval 1.
/// Rule 6.
template <class Bits, int N>
struct ScaleEstimator : StagePipeline<EstimateJob, EstimateResult, 3, estimate_scale<Bits, N>> {
  using StagePipeline<EstimateJob, EstimateResult, 3, estimate_scale<Bits, N>>::StagePipeline;
};

}  // namespace cbvh::rtl
