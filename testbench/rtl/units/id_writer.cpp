// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "rtl_model/lbvh/id_writer.h"

#include "testbench/rtl/write_bench.h"

namespace cbvh::testbench {

namespace {

bool run_steps(std::span<const vectors::IdStep> steps, const RunOptions& options, std::uint64_t number,
               Responses& responses) {
  std::vector<rtl::IdEntry> entries;
  std::size_t scenes = 0;
  for (const vectors::IdStep& step : steps) {
    entries.push_back(step.entry);
    scenes += step.entry.last.value();
  }
  return run_writer<rtl::IdEntry>(
      [base = steps.front().base](auto& items, auto& requests, auto& answers, auto& reports) {
        return rtl::IdWriter(items, requests, answers, reports, base);
      },
      entries, scenes, options, number, responses);
}

}  // namespace

UnitDriver id_writer_driver() {
  return {"id_writer", [](const vectors::VectorSet& set, const RunOptions& options) {
            Responses responses(sizeof(vectors::WriteEvent));
            for (std::size_t index = 0; index < set.size(); ++index) {
              const auto steps = typed_stimuli<vectors::IdStep, vectors::WriteEvent>(set, set.stimulus_range(index));
              responses.end_case(!run_steps(steps, options, set.head(index).id, responses));
            }
            return responses;
          }};
}

}  // namespace cbvh::testbench
