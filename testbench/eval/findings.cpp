// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/eval/findings.h"

#include <fmt/format.h>

#include "testbench/exit_code.h"

namespace cbvh::testbench {

int report(const Findings& findings, const Output& output, const std::string& heading, Json json) {
  json["checks"] = findings.checks;
  json["failures"] = findings.failures;
  json["tables"] = Json::object();
  std::string text = heading;
  std::string csv = kCsvHeading;
  for (const Table& table : findings.tables) {
    json["tables"][table.key] = to_json(table);
    csv += to_csv(table);
    if (table.in_text) text += to_markdown(table);
  }
  for (const std::string& failure : findings.failures) text += fmt::format("FAILED: {}\n", failure);
  text += fmt::format("{} checks passed, {} failed\n", findings.checks - findings.failures.size(),
                      findings.failures.size());
  output.text(text);
  output.csv(csv);
  output.json(json);
  return findings.failures.empty() && findings.checks > 0 ? kPass : kMismatch;
}

}  // namespace cbvh::testbench
