// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "testbench/report/json.h"

namespace cbvh::testbench {

/// A column of a table: its stable key, its heading, and how many decimals people see of its numbers.
struct Column {
  std::string key;
  std::string title;
  int decimals = 0;
  bool text_only = false;  ///< a drawing: not for programs
};

/// A table of one section of an evaluation. Text, JSON and CSV are written from it, so they cannot disagree; text
/// rounds.
struct Table {
  std::string key;
  std::string title;
  std::vector<Column> columns;
  std::size_t labels = 1;               ///< the leading columns that name a row, together unique
  std::vector<std::vector<Json>> rows;  ///< a cell a column; null: there is no such figure
  std::vector<std::string> notes;
  bool in_text = true;  ///< not only for programs
};

/// A heading, the table with padded cells, and the notes as a list.
std::string to_markdown(const Table& table);

/// {title, labels, columns: [{key, title, decimals}], rows: [{column key: value}], notes}
Json to_json(const Table& table);

/// Lines "table,row,column,value" with one figure each; a row is called by its labels, joined by '/'. No heading line.
std::string to_csv(const Table& table);
inline constexpr const char* kCsvHeading = "table,row,column,value\n";

/// length / scale characters, rounded.
std::string bar(char mark, double length, double scale);

}  // namespace cbvh::testbench
