// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "rtl_model/compress/axis_compressor.h"
#include "rtl_model/bits/machine_bits.h"
#include "testbench/lockstep/in_out.h"

namespace cbvh::testbench {

LockstepTwin axis_compressor_twin() {
  return {"axis_compressor", kLockstepBits, verilog_bits,
          [](const vectors::Parameters& parameters, const RunOptions& options, std::uint64_t seed) {
            return with_lockstep_bits(parameters.bits, [&]<int N>(std::integral_constant<int, N>) {
              return record_cases<rtl::AxisJob, rtl::AxisResult<N>>(
                  [](auto& jobs, auto& results) { return rtl::AxisCompressor<rtl::MachineBits, N>(jobs, results); },
                  "axis_compressor", parameters, 1000, options, seed);
            });
          }};
}

}  // namespace cbvh::testbench
