// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "rtl_model/compress/serial_node_pair_compressor.h"

#include "testbench/rtl/counting_bits.h"
#include "testbench/rtl/in_out_bench.h"

namespace cbvh::testbench {

UnitDriver node_pair_compressor_serial_driver() {
  return {
      "node_pair_compressor_serial", [](const vectors::VectorSet& set, const RunOptions& options) {
        return vectors::with_bits(set.parameters().bits, [&]<int N>(std::integral_constant<int, N>) {
          return stream_cases<rtl::PairJob, rtl::PairResult<N>>(
              [](auto& jobs, auto& results) { return rtl::SerialNodePairCompressor<CountingBits, N>(jobs, results); },
              set, options);
        });
      }};
}

}  // namespace cbvh::testbench
