// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_model/datapath/axis_compress.h"
#include "rtl_model/kernel/channel.h"
#include "rtl_model/kernel/stage_pipeline.h"

namespace cbvh::rtl {

/// Compresses one axis of one child a clock. Latency 3, initiation interval 1. Paper fig. 5 and 6.
template <class Bits, int N>
struct AxisCompressor : StagePipeline<AxisJob, AxisResult<N>, 3, compress_axis<Bits, N>> {
  using StagePipeline<AxisJob, AxisResult<N>, 3, compress_axis<Bits, N>>::StagePipeline;
};

}  // namespace cbvh::rtl
