// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "testbench/eval/table.h"
#include "testbench/output.h"

namespace cbvh::testbench {

/// What an evaluation has checked, what of it was wrong, and its figures.
struct Findings {
  std::uint64_t checks = 0;
  std::vector<std::string> failures;
  std::vector<Table> tables;

  /// Adds the checks and failures of a measure.
  template <class Measure>
  void add(const Measure& measure) {
    checks += measure.checks;
    failures.insert(failures.end(), measure.failures.begin(), measure.failures.end());
  }
  template <class Measure>
  void add_all(const std::vector<Measure>& measures) {
    for (const Measure& measure : measures) add(measure);
  }
};

/// Writes the tables, failures and number of checks: as text behind `heading`, as JSON {..., checks, failures, tables}
/// behind what `json` has, and as CSV. Returns the exit code; zero checks are a failure.
int report(const Findings& findings, const Output& output, const std::string& heading = {}, Json json = Json::object());

}  // namespace cbvh::testbench
