// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "rtl_model/lbvh/run_sorter.h"

#include "testbench/rtl/counting_bits.h"
#include "testbench/rtl/in_out_bench.h"
#include "vectors/units/run_sorter.h"

namespace cbvh::testbench {

UnitDriver run_sorter_driver() {
  return {"run_sorter", [](const vectors::VectorSet& set, const RunOptions& options) {
            return run_episodes<rtl::SortItem, rtl::SortItem>(
                [](auto& items, auto& sorted) {
                  return rtl::RunSorter<CountingBits>(items, sorted, vectors::kSorterCapacity);
                },
                set, options);
          }};
}

}  // namespace cbvh::testbench
