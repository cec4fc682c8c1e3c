// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_model/datapath/pair_compress.h"
#include "rtl_model/kernel/stage_pipeline.h"

namespace cbvh::rtl {

/// Compresses a node pair a clock: three scale estimators, then six axis compressors. Latency 6, initiation interval 1.
/// Paper section 4.2.1.
template <class Bits, int N>
struct NodePairCompressor : StagePipeline<PairJob, PairResult<N>, 6, compress_pair<Bits, N>> {
  using StagePipeline<PairJob, PairResult<N>, 6, compress_pair<Bits, N>>::StagePipeline;
};

}  // namespace cbvh::rtl
