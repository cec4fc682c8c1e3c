// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "rtl_model/traverse/box_decoder.h"

#include "testbench/rtl/counting_bits.h"
#include "testbench/rtl/in_out_bench.h"

namespace cbvh::testbench {

UnitDriver box_decoder_driver() {
  return {"box_decoder", [](const vectors::VectorSet& set, const RunOptions& options) {
            return vectors::with_bits(set.parameters().bits, [&]<int N>(std::integral_constant<int, N>) {
              return stream_cases<rtl::DecodeJob<N>, rtl::DecodeResult>(
                  [](auto& jobs, auto& results) { return rtl::BoxDecoder<CountingBits, N>(jobs, results); }, set,
                  options);
            });
          }};
}

}  // namespace cbvh::testbench
