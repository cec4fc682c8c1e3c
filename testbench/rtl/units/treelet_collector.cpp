// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "rtl_model/compress/treelet_collector.h"

#include "testbench/rtl/counting_bits.h"
#include "testbench/rtl/in_out_bench.h"

namespace cbvh::testbench {

UnitDriver treelet_collector_driver() {
  return {"treelet_collector", [](const vectors::VectorSet& set, const RunOptions& options) {
            return vectors::with_bits(set.parameters().bits, [&]<int N>(std::integral_constant<int, N>) {
              return run_episodes<rtl::StreamJob, rtl::FinalPair<N>>(
                  [levels = set.parameters().treelet](auto& jobs, auto& results) {
                    return rtl::TreeletCollector<CountingBits, N>(jobs, results, levels);
                  },
                  set, options);
            });
          }};
}

}  // namespace cbvh::testbench
