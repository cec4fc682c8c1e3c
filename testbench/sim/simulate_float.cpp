// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "rtl_model/lbvh/float_output.h"
#include "testbench/sim/lbvh_simulation.h"

namespace cbvh::testbench {

SimResult simulate_float(const LbvhJob& job) {
  return run_lbvh<rtl::FloatOutput>(job, [&](SimResult& result, const auto& outcome) {
    result.difference = compare_float_pairs(job.floats, job.config.float_pairs.value(), outcome.store);
    add_traffic(result, "float pairs written", outcome.ports.at("float_node_writer"), 64 * result.pairs,
                64 * result.pairs, "");
  });
}

}  // namespace cbvh::testbench
