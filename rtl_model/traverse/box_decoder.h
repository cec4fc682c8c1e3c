// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_model/datapath/decode_box.h"
#include "rtl_model/kernel/channel.h"
#include "rtl_model/kernel/stage_pipeline.h"

namespace cbvh::rtl {

/// Decodes one child of a stored pair a clock. Latency 3, initiation interval 1. Paper fig. 4, equations 3 and 9.
template <class Bits, int N>
struct BoxDecoder : StagePipeline<DecodeJob<N>, DecodeResult, 3, decode_box<Bits, N>> {
  using StagePipeline<DecodeJob<N>, DecodeResult, 3, decode_box<Bits, N>>::StagePipeline;
};

}  // namespace cbvh::rtl
