// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "rtl_model/compress/scale_estimator.h"
#include "rtl_model/bits/machine_bits.h"
#include "testbench/lockstep/in_out.h"

namespace cbvh::testbench {

LockstepTwin scale_estimator_twin() {
  return {"scale_estimator", kLockstepBits, verilog_bits,
          [](const vectors::Parameters& parameters, const RunOptions& options, std::uint64_t seed) {
            return with_lockstep_bits(parameters.bits, [&]<int N>(std::integral_constant<int, N>) {
              return record_cases<rtl::EstimateJob, rtl::EstimateResult>(
                  [](auto& jobs, auto& results) { return rtl::ScaleEstimator<rtl::MachineBits, N>(jobs, results); },
                  "scale_estimator", parameters, 1000, options, seed);
            });
          }};
}

}  // namespace cbvh::testbench
