// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "rtl_model/bits/machine_bits.h"
#include "rtl_model/compress/serial_node_pair_compressor.h"
#include "testbench/lockstep/in_out.h"

namespace cbvh::testbench {

LockstepTwin node_pair_compressor_serial_twin() {
  return {"node_pair_compressor_serial", kLockstepBits, verilog_bits,
          [](const vectors::Parameters& parameters, const RunOptions& options, std::uint64_t seed) {
            return with_lockstep_bits(parameters.bits, [&]<int N>(std::integral_constant<int, N>) {
              return record_cases<rtl::PairJob, rtl::PairResult<N>>(
                  [](auto& jobs, auto& results) {
                    return rtl::SerialNodePairCompressor<rtl::MachineBits, N>(jobs, results);
                  },
                  "node_pair_compressor_serial", parameters, 60, options, seed);
            });
          }};
}

}  // namespace cbvh::testbench
