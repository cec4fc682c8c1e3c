// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "rtl_model/compress/treelet_collector.h"

#include "rtl_model/bits/machine_bits.h"
#include "testbench/lockstep/in_out.h"

namespace cbvh::testbench {

/// All trees of a set in one episode: full queues, refused trees before good ones.
LockstepTwin treelet_collector_twin() {
  return {"treelet_collector",
          {{2, 1}, {6, 2}},
          verilog_bits_and_levels,
          [](const vectors::Parameters& parameters, const RunOptions& options, std::uint64_t seed) {
            return with_lockstep_bits(parameters.bits, [&]<int N>(std::integral_constant<int, N>) {
              const auto set = vectors::generate_set("treelet_collector", parameters, 21, seed);
              const auto jobs = typed_stimuli<rtl::StreamJob, rtl::FinalPair<N>>(*set, {0, set->stimulus_count()});
              return std::vector<Episode>{record_in_out<rtl::StreamJob, rtl::FinalPair<N>>(
                  [&](auto& in, auto& out) {
                    return rtl::TreeletCollector<rtl::MachineBits, N>(in, out, parameters.treelet);
                  },
                  jobs, options, seed, "jobs", "finals")};
            });
          }};
}

}  // namespace cbvh::testbench
