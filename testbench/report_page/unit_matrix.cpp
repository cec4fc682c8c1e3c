// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/report_page/unit_matrix.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "testbench/report_page/table.h"

namespace cbvh::testbench {

namespace {

struct Cell {
  std::uint64_t checks = 0;
  std::uint64_t failures = 0;
};

struct Matrix {
  std::vector<std::string> units;  ///< in the order they were first seen
  std::set<std::string> backends;
  std::map<std::string, std::map<std::string, Cell>> cells;

  void add_unit(const std::string& unit) {
    if (std::find(units.begin(), units.end(), unit) == units.end()) units.push_back(unit);
  }
};

Matrix matrix_of(const std::vector<Result>& results) {
  Matrix matrix;
  for (const Result& result : results) {
    if (result.kind.name == units_kind().name) {
      for (const Json& unit : result.json.at("units")) matrix.add_unit(unit.at("name"));
    }
    if (result.kind.name != checks_kind().name) continue;
    for (const Json& set : result.json.at("sets")) {
      const std::string unit = set.at("unit");
      const std::string backend = set.at("backend");
      matrix.add_unit(unit);
      matrix.backends.insert(backend);
      Cell& cell = matrix.cells[unit][backend];
      cell.checks += count(set, "checks");
      cell.failures += count(set, "failures");
    }
  }
  return matrix;
}

Markup cell_of(const Cell& cell) {
  if (cell.failures != 0)
    return element("td", {{"class", "number failed"}},
                   fmt::format("\u2717 {} of {} failed", count_text(cell.failures), count_text(cell.checks)));
  if (cell.checks == 0) return element("td", {{"class", "number none"}}, "\u2013 not checked");
  return element("td", {{"class", "number passed"}}, "\u2713 " + count_text(cell.checks));
}

}  // namespace

Markup unit_matrix(const std::vector<Result>& results) {
  Matrix matrix = matrix_of(results);
  if (matrix.units.empty()) return {};
  if (matrix.backends.empty()) matrix.backends.insert("any backend");
  Markup head = element("th", {{"scope", "col"}}, "unit");
  for (const std::string& backend : matrix.backends)
    head += element("th", {{"scope", "col"}, {"class", "number"}}, backend);
  Markup body;
  for (const std::string& unit : matrix.units) {
    Markup line = element("th", {{"scope", "row"}}, unit);
    for (const std::string& backend : matrix.backends) line += cell_of(matrix.cells[unit][backend]);
    body += element("tr", Attributes{}, line);
  }
  Markup content = element("caption", "Checks of each unit on each backend");
  content += element("thead", Attributes{}, element("tr", Attributes{}, head));
  content += element("tbody", Attributes{}, body);
  return element("div", {{"class", "scroll matrix"}}, element("table", Attributes{}, content));
}

}  // namespace cbvh::testbench
