// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/regression/check_set.h"

#include <algorithm>

#include "testbench/scoreboard/minimise.h"
#include "testbench/scoreboard/scoreboard.h"
#include "vectors/format/format.h"

namespace cbvh::testbench {

namespace {

constexpr std::uint64_t kQuickHang = 2000;  ///< cycles: hundreds of attempts may hang

/// The smallest case that fails as this one does, as a file; empty when it fails only in company: after other cases.
std::string minimal_case(const vectors::VectorSet& set, const Backend& backend, RunOptions run_options,
                         const CompareOptions& compare_options, std::uint64_t id) {
  run_options.hang_cycles = std::min(run_options.hang_cycles, kQuickHang);
  const auto still_fails = [&](const vectors::VectorSet& one) {
    SetReport scratch;
    compare(one, backend.run(one, run_options), compare_options, scratch);
    return scratch.failures != 0;
  };
  const auto smaller = minimise(set, set.find(id), still_fails);
  return still_fails(*smaller) ? vectors::serialize(*smaller, vectors::Format::text) : "";
}

}  // namespace

Bins empty_classes(const vectors::UnitDescription& unit) {
  Bins bins;
  for (std::size_t i = 0; i < unit.generated_classes(); ++i) bins[std::string(unit.classes[i])] = 0;
  return bins;
}

void check_set(const vectors::VectorSet& set, const Backend& backend, const RunOptions& options,
               const std::function<std::string(std::uint64_t id)>& rerun, SetReport& report) {
  const CompareOptions compare_options{options.stalls != Stalls::none, rerun};
  const bool failed_before = !report.mismatches.empty();
  compare(set, backend.run(set, options), compare_options, report);
  if (failed_before || report.mismatches.empty()) return;
  Mismatch& first = report.mismatches.front();
  first.minimal = minimal_case(set, backend, options, compare_options, first.id);
}

}  // namespace cbvh::testbench
