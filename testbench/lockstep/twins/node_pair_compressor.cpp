// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "rtl_model/compress/node_pair_compressor.h"
#include "rtl_model/bits/machine_bits.h"
#include "testbench/lockstep/in_out.h"

namespace cbvh::testbench {

LockstepTwin node_pair_compressor_twin() {
  return {"node_pair_compressor", kLockstepBits, verilog_bits,
          [](const vectors::Parameters& parameters, const RunOptions& options, std::uint64_t seed) {
            return with_lockstep_bits(parameters.bits, [&]<int N>(std::integral_constant<int, N>) {
              return record_cases<rtl::PairJob, rtl::PairResult<N>>(
                  [](auto& jobs, auto& results) { return rtl::NodePairCompressor<rtl::MachineBits, N>(jobs, results); },
                  "node_pair_compressor", parameters, 250, options, seed);
            });
          }};
}

}  // namespace cbvh::testbench
