// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include <cstring>

#include "testbench/backend/backend.h"
#include "vectors/registry.h"

namespace cbvh::testbench {

namespace {

/// The reference itself: what it gives is right by definition, so running it checks the responses stored in a set.
class GoldenBackend final : public Backend {
 public:
  std::string name() const override { return "golden"; }
  bool has(const vectors::UnitDescription&) const override { return true; }
  bool stalls() const override { return false; }

  Responses run(const vectors::VectorSet& set, const RunOptions&) const override {
    Responses responses(set.response_codec().object_size);
    responses.reserve(set.response_count());
    const auto scratch = vectors::make_set(set.unit(), set.parameters(), set.seed());
    for (std::size_t index = 0; index < set.size(); ++index) {
      scratch->clear();
      scratch->begin_case(set.head(index).id, set.head(index).case_class);
      const auto stimuli = set.stimulus_range(index);
      for (std::size_t i = 0; i < stimuli.size; ++i) {
        std::memcpy(scratch->add_stimulus(), set.stimulus_at(stimuli.begin + i), set.stimulus_codec().object_size);
      }
      scratch->complete_case();
      for (std::size_t i = 0; i < scratch->response_count(); ++i)
        responses.add(scratch->response_at(i), scratch->latency_at(i));
      responses.end_case();
    }
    return responses;
  }
};

}  // namespace

std::unique_ptr<Backend> make_golden_backend() { return std::make_unique<GoldenBackend>(); }

}  // namespace cbvh::testbench
