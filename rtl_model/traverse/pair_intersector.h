// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_model/datapath/intersect_pair.h"
#include "rtl_model/kernel/channel.h"
#include "rtl_model/kernel/stage_pipeline.h"

namespace cbvh::rtl {

/// Both children of a stored pair against a ray, a pair a clock. Latency 8, initiation interval 1. Paper fig. 4,
/// equations 5 and 9.
template <class Bits, int N>
struct PairIntersector : StagePipeline<PairTestJob<N>, PairTestResult<N>, 8, intersect_pair<Bits, N>> {
  using StagePipeline<PairTestJob<N>, PairTestResult<N>, 8, intersect_pair<Bits, N>>::StagePipeline;
};

}  // namespace cbvh::rtl
