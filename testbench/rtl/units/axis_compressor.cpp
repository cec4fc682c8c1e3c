// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "rtl_model/compress/axis_compressor.h"

#include "testbench/rtl/counting_bits.h"
#include "testbench/rtl/in_out_bench.h"

namespace cbvh::testbench {

UnitDriver axis_compressor_driver() {
  return {"axis_compressor", [](const vectors::VectorSet& set, const RunOptions& options) {
            return vectors::with_bits(set.parameters().bits, [&]<int N>(std::integral_constant<int, N>) {
              return stream_cases<rtl::AxisJob, rtl::AxisResult<N>>(
                  [](auto& jobs, auto& results) { return rtl::AxisCompressor<CountingBits, N>(jobs, results); }, set,
                  options);
            });
          }};
}

}  // namespace cbvh::testbench
