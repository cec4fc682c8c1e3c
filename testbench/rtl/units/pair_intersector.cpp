// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "rtl_model/traverse/pair_intersector.h"

#include "testbench/rtl/counting_bits.h"
#include "testbench/rtl/in_out_bench.h"

namespace cbvh::testbench {

UnitDriver pair_intersector_driver() {
  return {"pair_intersector", [](const vectors::VectorSet& set, const RunOptions& options) {
            return vectors::with_bits(set.parameters().bits, [&]<int N>(std::integral_constant<int, N>) {
              return stream_cases<rtl::PairTestJob<N>, rtl::PairTestResult<N>>(
                  [](auto& jobs, auto& results) { return rtl::PairIntersector<CountingBits, N>(jobs, results); }, set,
                  options);
            });
          }};
}

}  // namespace cbvh::testbench
