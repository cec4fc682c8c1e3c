// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "rtl_model/lbvh/morton_encoder.h"

#include "testbench/rtl/counting_bits.h"
#include "testbench/rtl/in_out_bench.h"
#include "vectors/lbvh_payloads.h"

namespace cbvh::testbench {

UnitDriver morton_encoder_driver() {
  return {"morton_encoder", [](const vectors::VectorSet& set, const RunOptions& options) {
            Responses responses(sizeof(rtl::SortItem));
            responses.reserve(set.response_count());
            std::vector<rtl::PrimitiveBox> boxes;
            for (std::size_t index = 0; index < set.size(); ++index) {
              const auto jobs = typed_stimuli<vectors::MortonJob, rtl::SortItem>(set, set.stimulus_range(index));
              boxes.clear();
              for (const vectors::MortonJob& job : jobs) boxes.push_back(job.box);
              const auto scene = jobs.empty() ? rtl::SceneBox() : jobs.front().registers;
              const auto trace = run_in_out<rtl::PrimitiveBox, rtl::SortItem>(
                  [&](auto& in, auto& out) { return rtl::MortonEncoder<CountingBits>(in, out, scene); }, boxes,
                  jobs.size(), Origin::first_job, options, set.head(index).id);
              for (std::size_t i = 0; i < trace.results.size(); ++i) {
                responses.add(&trace.results[i], trace.latencies[i]);
              }
              responses.end_case(trace.hung);
              responses.cycles += trace.cycles;
            }
            return responses;
          }};
}

}  // namespace cbvh::testbench
