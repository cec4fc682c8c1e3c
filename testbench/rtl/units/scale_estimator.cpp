// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "rtl_model/compress/scale_estimator.h"

#include "testbench/rtl/counting_bits.h"
#include "testbench/rtl/in_out_bench.h"

namespace cbvh::testbench {

UnitDriver scale_estimator_driver() {
  return {"scale_estimator", [](const vectors::VectorSet& set, const RunOptions& options) {
            return vectors::with_bits(set.parameters().bits, [&]<int N>(std::integral_constant<int, N>) {
              return stream_cases<rtl::EstimateJob, rtl::EstimateResult>(
                  [](auto& jobs, auto& results) { return rtl::ScaleEstimator<CountingBits, N>(jobs, results); }, set,
                  options);
            });
          }};
}

}  // namespace cbvh::testbench
