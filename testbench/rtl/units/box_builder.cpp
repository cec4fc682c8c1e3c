// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "rtl_model/lbvh/box_builder.h"

#include "testbench/rtl/counting_bits.h"
#include "testbench/rtl/in_out_bench.h"

namespace cbvh::testbench {

UnitDriver box_builder_driver() {
  return {"box_builder", [](const vectors::VectorSet& set, const RunOptions& options) {
            return stream_cases<rtl::Primitive, rtl::PrimitiveBox>(
                [](auto& primitives, auto& boxes) { return rtl::BoxBuilder<CountingBits>(primitives, boxes); }, set,
                options);
          }};
}

}  // namespace cbvh::testbench
