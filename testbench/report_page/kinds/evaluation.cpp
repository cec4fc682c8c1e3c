// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/report_page/kinds/table_plots.h"
#include "testbench/report_page/result.h"
#include "testbench/report_page/table.h"

/// `cbvh eval` and its subcommands, and every other command whose result is tables.
namespace cbvh::testbench {

namespace {

/// Tables without counts have not been checked.
Tally tally(const Json& json) {
  if (!json.contains("checks")) return {};
  const std::uint64_t failed = json.at("failures").size();
  const std::uint64_t checks = count(json, "checks");
  return {checks < failed ? 0 : checks - failed, failed, 0};
}

Markup show(const Json& json, Figures& figures) {
  Markup markup;
  Markup failures;
  if (json.contains("failures")) {
    for (const Json& failure : json.at("failures")) failures += element("li", failure.get<std::string>());
  }
  if (!failures.empty()) markup += element("ul", {{"class", "failures"}}, failures);
  const Json& tables = json.at("tables");
  for (const auto& [key, table] : tables.items()) {
    markup += result_table(table);
    markup += draw_table(key, tables, figures);
  }
  return markup;
}

}  // namespace

ResultKind evaluation_kind() {
  return {"evaluation", "cbvh eval|eval builders|eval rays|eval space|eval two-level|trace --compare --json",
          {"tables"},   Chapter::evaluations,
          tally,        show};
}

}  // namespace cbvh::testbench
