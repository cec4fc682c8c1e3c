// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "rtl_model/lbvh/top_down_output.h"
#include "testbench/sim/streaming_simulation.h"

namespace cbvh::testbench {

SimResult simulate_top_down(const LbvhJob& job) {
  const SimConfig& config = job.request.config;
  return with_simulated_bits(config.bits, [&]<int N>(std::integral_constant<int, N>) {
    using Output = rtl::TopDownOutput<rtl::MachineBits, N>;
    return run_lbvh<Output>(job, [&](SimResult& result, const auto& outcome) {
      const rtl::StreamReport report = accepted_report(job, result, outcome);
      compare_compressed(result, job.floats, config, job.config.pairs, job.config.ids, report.root, outcome.store);
      add_traffic(result, "float pairs written", outcome.ports.at("float_node_writer"), 64 * result.pairs,
                  64 * result.pairs, "");
      add_traffic(result, "float pairs read", outcome.ports.at("top_down_read"), 64 * result.pairs, 64 * result.pairs,
                  "");
      add_traffic(result, "pairs written", outcome.ports.at("top_down_write"), 16 * result.pairs,
                  whole_lines(16 * result.pairs), "the last line");
    });
  });
}

}  // namespace cbvh::testbench
