// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "rtl_model/traverse/ray_setter.h"

#include "testbench/rtl/counting_bits.h"
#include "testbench/rtl/in_out_bench.h"

namespace cbvh::testbench {

UnitDriver ray_setter_driver() {
  return {"ray_setter", [](const vectors::VectorSet& set, const RunOptions& options) {
            return stream_cases<rtl::RaySetupJob, rtl::RaySetupResult>(
                [](auto& jobs, auto& results) { return rtl::RaySetter<CountingBits>(jobs, results); }, set, options);
          }};
}

}  // namespace cbvh::testbench
