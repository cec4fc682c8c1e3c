// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "rtl_model/compress/treelet_collector.h"
#include "testbench/sim/streaming_simulation.h"

namespace cbvh::testbench {

SimResult simulate_streaming_full(const LbvhJob& job) { return simulate_streaming<rtl::TreeletCollector>(job); }

}  // namespace cbvh::testbench
