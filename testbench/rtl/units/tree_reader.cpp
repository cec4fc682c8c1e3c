// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "rtl_model/refit/tree_reader.h"

#include "testbench/rtl/array_reader_bench.h"

namespace cbvh::testbench {

UnitDriver tree_reader_driver() { return {"tree_reader", run_array_reader<rtl::TreeReader, rtl::TopologyPair>}; }

}  // namespace cbvh::testbench
