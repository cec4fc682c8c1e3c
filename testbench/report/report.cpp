// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/report/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>

namespace cbvh::testbench {

namespace {

void add_bins(Bins& into, const Bins& part) {
  for (const auto& [bin, hits] : part) into[bin] += hits;
}

void find_empty(const std::string& kind, const Bins& bins, Verdict& verdict) {
  for (const auto& [bin, hits] : bins) {
    if (hits == 0) verdict.empty_bins.push_back(kind + bin);
  }
}

}  // namespace

std::map<std::string, Bins> Report::classes() const {
  std::map<std::string, Bins> result;
  for (const SetReport& set : sets) add_bins(result[set.unit], set.classes);
  return result;
}

Verdict judge(const Report& report) {
  Verdict verdict;
  for (const SetReport& set : report.sets) {
    verdict.passed += set.checks - set.failures;
    verdict.failed += set.failures;
    if (set.checks == 0 && (is_whole(report.shard) || set.cases != 0)) {
      verdict.empty_sets.push_back(fmt::format("{} {} {}", set.unit, set.set, set.mode));
    }
  }
  verdict.failed += verdict.empty_sets.size();
  if (!is_whole(report.shard)) return verdict;
  for (const auto& [unit, bins] : report.classes()) find_empty("class " + unit + '/', bins, verdict);
  find_empty("corner ", report.corners, verdict);
  if (report.bins_must_be_hit) verdict.failed += verdict.empty_bins.size();
  return verdict;
}

void accumulate(SetReport& into, const SetReport& part) {
  assert(into.key() == part.key() && into.total_cases == part.total_cases);
  into.cases += part.cases;
  into.checks += part.checks;
  into.failures += part.failures;
  into.cycles += part.cycles;
  into.seconds += part.seconds;
  add_bins(into.classes, part.classes);
  into.mismatches.insert(into.mismatches.end(), part.mismatches.begin(), part.mismatches.end());
  std::stable_sort(into.mismatches.begin(), into.mismatches.end(),
                   [](const Mismatch& a, const Mismatch& b) { return a.id < b.id; });
  if (into.mismatches.size() > kMismatchesKept) into.mismatches.resize(kMismatchesKept);
}

}  // namespace cbvh::testbench
