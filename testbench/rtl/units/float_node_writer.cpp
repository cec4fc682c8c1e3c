// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "rtl_model/lbvh/float_node_writer.h"

#include "testbench/rtl/write_bench.h"
#include "vectors/units/float_node_writer.h"

namespace cbvh::testbench {

UnitDriver float_node_writer_driver() {
  return {"float_node_writer", [](const vectors::VectorSet& set, const RunOptions& options) {
            Responses responses(sizeof(vectors::WriteEvent));
            for (std::size_t index = 0; index < set.size(); ++index) {
              const auto jobs = typed_stimuli<rtl::StreamJob, vectors::WriteEvent>(set, set.stimulus_range(index));
              const auto trees =
                  std::count_if(jobs.begin(), jobs.end(), [](const auto& job) { return bool(job.root); });
              const bool finished = run_writer<rtl::StreamJob>(
                  [](auto& items, auto& requests, auto& answers, auto& reports) {
                    return rtl::FloatNodeWriter(items, requests, answers, reports, vectors::kFloatPairBase);
                  },
                  jobs, static_cast<std::size_t>(trees), options, set.head(index).id, responses);
              responses.end_case(!finished);
            }
            return responses;
          }};
}

}  // namespace cbvh::testbench
