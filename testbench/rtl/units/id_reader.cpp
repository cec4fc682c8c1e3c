// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "rtl_model/refit/id_reader.h"

#include "testbench/rtl/array_reader_bench.h"

namespace cbvh::testbench {

UnitDriver id_reader_driver() { return {"id_reader", run_array_reader<rtl::IdReader, rtl::IdEntry>}; }

}  // namespace cbvh::testbench
