// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/report/print.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace cbvh::testbench {

namespace {

std::string hit_bins(const std::string& title, const Bins& bins) {
  const auto hit = std::count_if(bins.begin(), bins.end(), [](const auto& bin) { return bin.second != 0; });
  std::string line = fmt::format("{} {}/{}:", title, hit, bins.size());
  for (const auto& [bin, hits] : bins) line += fmt::format(" {} {}", bin, hits);
  return line + '\n';
}

std::set<std::string> backends(const Report& report) {
  std::set<std::string> names;
  for (const SetReport& set : report.sets) names.insert(set.backend);
  return names;
}

std::string coverage(const Report& report, const Verdict& verdict) {
  std::string text = "coverage\n";
  for (const auto& [unit, bins] : report.classes()) {
    if (!bins.empty()) text += hit_bins("  classes of " + unit, bins);
  }
  if (!report.corners.empty()) {
    text += hit_bins("  corners of the model", report.corners);
  } else if (!report.sets.empty()) {
    text += fmt::format("  corners of the model: not observed by {}\n", fmt::join(backends(report), ", "));
  }
  for (const std::string& bin : verdict.empty_bins) {
    text += fmt::format("{}: {} was never hit\n", report.bins_must_be_hit ? "FAILED" : "warning", bin);
  }
  return text;
}

}  // namespace

std::string to_string(const Mismatch& mismatch) {
  std::string text = fmt::format("mismatch: unit {}, set {}, case {} ({}), response {}, field {}: found {}, wanted {}",
                                 mismatch.unit, mismatch.set, mismatch.id, mismatch.case_class, mismatch.response,
                                 mismatch.field, mismatch.found, mismatch.wanted);
  if (!mismatch.rerun.empty()) text += "\n  rerun: " + mismatch.rerun;
  if (!mismatch.minimal.empty()) text += "\n  minimal case:\n" + mismatch.minimal;
  return text;
}

std::string to_string(const SetReport& set) {
  const double rate = set.seconds > 0 ? static_cast<double>(set.cases) / set.seconds : 0;
  return fmt::format("{:<28} {:<44} {:<8} {:<14} {:>9} cases {:>10} checks {:>6} failures {:>10.0f} cases/s", set.unit,
                     set.set, set.backend, set.mode, set.cases, set.checks, set.failures, rate);
}

std::string to_string(const Report& report) {
  const Verdict verdict = judge(report);
  std::string text;
  for (const SetReport& set : report.sets) {
    text += to_string(set) + '\n';
    for (const Mismatch& mismatch : set.mismatches) text += to_string(mismatch) + '\n';
  }
  if (is_whole(report.shard)) text += coverage(report, verdict);
  for (const std::string& set : verdict.empty_sets) text += fmt::format("FAILED: {}: zero checks\n", set);
  if (verdict.passed + verdict.failed == 0) text += "FAILED: zero checks: nothing was compared\n";
  return text + fmt::format("{} passed, {} failed\n", verdict.passed, verdict.failed);
}

}  // namespace cbvh::testbench
