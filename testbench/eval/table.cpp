// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/eval/table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace cbvh::testbench {

namespace {

std::string cell_text(const Json& cell, const Column& column) {
  if (cell.is_null()) return "-";
  if (cell.is_string()) return cell.get<std::string>();
  if (cell.is_number_float()) return fmt::format("{:.{}f}", cell.get<double>(), column.decimals);
  return cell.dump();
}

/// '|' would end the cell.
std::string escape_markdown(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '|') escaped += '\\';
    escaped += c;
  }
  return escaped;
}

/// RFC 4180.
std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return quoted + '"';
}

std::string plain(const Json& cell) { return cell.is_string() ? cell.get<std::string>() : cell.dump(); }

/// One line of the table; text is flushed left, numbers right.
std::string markdown_line(const std::vector<std::string>& cells, const std::vector<std::size_t>& widths,
                          const std::vector<bool>& left) {
  std::string line = "|";
  for (std::size_t i = 0; i < cells.size(); ++i) {
    line += left[i] ? fmt::format(" {:<{}} |", cells[i], widths[i]) : fmt::format(" {:>{}} |", cells[i], widths[i]);
  }
  return line + '\n';
}

}  // namespace

std::string to_markdown(const Table& table) {
  const std::size_t count = table.columns.size();
  std::vector<std::vector<std::string>> lines(1);
  std::vector<bool> left(count, false);
  for (const Column& column : table.columns) lines[0].push_back(escape_markdown(column.title));
  for (const auto& row : table.rows) {
    std::vector<std::string> line;
    for (std::size_t i = 0; i < count; ++i) {
      line.push_back(escape_markdown(cell_text(row[i], table.columns[i])));
      left[i] = left[i] || row[i].is_string();
    }
    lines.push_back(line);
  }
  std::vector<std::size_t> widths(count, 3);
  for (const auto& line : lines) {
    for (std::size_t i = 0; i < count; ++i) widths[i] = std::max(widths[i], line[i].size());
  }
  std::string text = fmt::format("## {}\n\n", table.title) + markdown_line(lines[0], widths, left) + '|';
  for (std::size_t i = 0; i < count; ++i)
    text += left[i] ? fmt::format(" {:-<{}} |", ":", widths[i]) : fmt::format(" {:->{}} |", ":", widths[i]);
  text += '\n';
  for (std::size_t i = 1; i < lines.size(); ++i) text += markdown_line(lines[i], widths, left);
  if (!table.notes.empty()) text += '\n';
  for (const std::string& note : table.notes) text += fmt::format("- {}\n", note);
  return text + '\n';
}

Json to_json(const Table& table) {
  Json columns = Json::array();
  for (const Column& column : table.columns) {
    if (!column.text_only)
      columns.push_back({{"key", column.key}, {"title", column.title}, {"decimals", column.decimals}});
  }
  Json rows = Json::array();
  for (const auto& row : table.rows) {
    Json object = Json::object();
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
      if (!table.columns[i].text_only) object[table.columns[i].key] = row[i];
    }
    rows.push_back(object);
  }
  return {
      {"title", table.title}, {"labels", table.labels}, {"columns", columns}, {"rows", rows}, {"notes", table.notes}};
}

std::string to_csv(const Table& table) {
  std::string text;
  for (const auto& row : table.rows) {
    std::string label;
    for (std::size_t i = 0; i < table.labels; ++i) label += (i == 0 ? "" : "/") + plain(row[i]);
    for (std::size_t i = table.labels; i < table.columns.size(); ++i) {
      if (table.columns[i].text_only || row[i].is_null()) continue;
      text += fmt::format("{},{},{},{}\n", table.key, csv_field(label), table.columns[i].key, csv_field(plain(row[i])));
    }
  }
  return text;
}

std::string bar(char mark, double length, double scale) {
  return std::string(static_cast<std::size_t>(std::lround(std::max(0.0, length / scale))), mark);
}

}  // namespace cbvh::testbench
