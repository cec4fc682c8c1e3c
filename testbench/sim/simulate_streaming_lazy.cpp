// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "rtl_model/compress/lazy_treelet_collector.h"
#include "testbench/sim/streaming_simulation.h"

namespace cbvh::testbench {

SimResult simulate_streaming_lazy(const LbvhJob& job) { return simulate_streaming<rtl::LazyTreeletCollector>(job); }

}  // namespace cbvh::testbench
