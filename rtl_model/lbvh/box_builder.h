// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_model/datapath/primitive_box.h"
#include "rtl_model/kernel/stage_pipeline.h"

namespace cbvh::rtl {

/// Makes the box of a primitive a clock: one stage compares two vertices, one the third. Latency 2, initiation
/// interval 1. Paper section 5.3: the LBVH builder sorts boxes.
template <class Bits>
struct BoxBuilder : StagePipeline<Primitive, PrimitiveBox, 2, primitive_box<Bits>> {
  using StagePipeline<Primitive, PrimitiveBox, 2, primitive_box<Bits>>::StagePipeline;
};

}  // namespace cbvh::rtl
