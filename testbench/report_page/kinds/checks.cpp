// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "testbench/report_page/result.h"
#include "testbench/report_page/table.h"

/// `cbvh regress`, `check` and `merge`: vector sets on backends.
namespace cbvh::testbench {

namespace {

Report report_of(const Json& json) {
  for (const Json& set : json.at("sets")) {
    for (const char* const key : {"total_cases", "cases", "checks", "failures"}) count(set, key);
  }
  return report_from_json(json.dump(), "report");
}

Tally tally(const Json& json) {
  const Report report = report_of(json);
  const Verdict verdict = judge(report);
  Tally tally{verdict.passed, verdict.failed, 0};
  for (const SetReport& set : report.sets) tally.skipped += set.total_cases - std::min(set.total_cases, set.cases);
  return tally;
}

Markup list(const std::string& title, const std::vector<std::string>& entries) {
  if (entries.empty()) return {};
  Markup details = element("summary", fmt::format("{} {}", entries.size(), title));
  Markup items;
  for (const std::string& entry : entries) items += element("li", entry);
  details += element("ul", {{"class", "notes"}}, items);
  return element("details", Attributes{}, details);
}

Markup mismatches(const Report& report) {
  std::vector<std::vector<std::string>> rows;
  for (const SetReport& set : report.sets) {
    for (const Mismatch& m : set.mismatches)
      rows.push_back({m.unit, m.set, std::to_string(m.id), m.field, m.found, m.wanted, m.rerun});
  }
  if (rows.empty()) return {};
  return plain_table("Mismatches", {"unit", "set", "case", "field", "found", "wanted", "runs it again"}, rows);
}

Markup show(const Json& json, Figures&) {
  const Report report = report_of(json);
  const Verdict verdict = judge(report);
  Markup markup = element("h3", fmt::format("{} {}, seed {}, shard {}", report.command, report.suite, report.seed,
                                            to_string(report.shard)));
  std::vector<std::vector<std::string>> rows;
  for (const SetReport& set : report.sets) {
    rows.push_back({set.unit, set.set, set.backend, set.mode, std::to_string(set.cases), std::to_string(set.checks),
                    std::to_string(set.failures)});
  }
  markup += mismatches(report);
  Markup details = element("summary", fmt::format("{} vector sets", rows.size()));
  details += plain_table("Vector sets", {"unit", "set", "backend", "mode", "cases", "checks", "failures"}, rows);
  markup += element("details", {{"class", "long"}}, details);
  markup += list("sets that checked nothing", verdict.empty_sets);
  markup += list(report.bins_must_be_hit ? "bins never hit, each a failure" : "bins never hit", verdict.empty_bins);
  return markup;
}

}  // namespace

ResultKind checks_kind() {
  return {"report of checks", "cbvh regress|check|merge --json", {"cbvh_report"}, Chapter::checks, tally, show};
}

}  // namespace cbvh::testbench
