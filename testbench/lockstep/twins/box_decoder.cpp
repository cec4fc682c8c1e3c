// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "rtl_model/traverse/box_decoder.h"
#include "rtl_model/bits/machine_bits.h"
#include "testbench/lockstep/in_out.h"

namespace cbvh::testbench {

LockstepTwin box_decoder_twin() {
  return {"box_decoder", kLockstepBits, verilog_bits,
          [](const vectors::Parameters& parameters, const RunOptions& options, std::uint64_t seed) {
            return with_lockstep_bits(parameters.bits, [&]<int N>(std::integral_constant<int, N>) {
              return record_cases<rtl::DecodeJob<N>, rtl::DecodeResult>(
                  [](auto& jobs, auto& results) { return rtl::BoxDecoder<rtl::MachineBits, N>(jobs, results); },
                  "box_decoder", parameters, 1000, options, seed);
            });
          }};
}

}  // namespace cbvh::testbench
