// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/report_page/table.h"

#include <fmt/format.h>

#include <algorithm>

namespace cbvh::testbench {

namespace {

constexpr std::size_t kLongTable = 30;  ///< rows
constexpr std::size_t kProse = 32;      ///< characters; longer cells get room

bool is_number(const std::string& text) {
  return text == "-" || (!text.empty() && text.find_first_not_of("0123456789.,+-e%") == std::string::npos);
}

struct Cells {
  std::vector<std::string> headings;
  std::vector<bool> from_paper;  ///< a column
  std::vector<std::vector<std::string>> rows;
  std::vector<bool> row_from_paper = {};
};

Markup table_of(const std::string& caption, const Cells& cells) {
  const std::size_t count = cells.headings.size();
  std::vector<bool> numbers(count, true);
  for (const auto& row : cells.rows) {
    for (std::size_t i = 0; i < count; ++i) numbers[i] = numbers[i] && is_number(row[i]);
  }
  const auto cell_class = [&](std::size_t i) {
    return std::string(numbers[i] ? "number" : "") + (cells.from_paper[i] ? " paper" : "");
  };
  Markup head;
  for (std::size_t i = 0; i < count; ++i)
    head += element("th", {{"scope", "col"}, {"class", cell_class(i)}}, cells.headings[i]);
  Markup body;
  for (std::size_t r = 0; r < cells.rows.size(); ++r) {
    Markup line;
    for (std::size_t i = 0; i < count; ++i) {
      const std::string& text = cells.rows[r][i];
      const std::string css_class = cell_class(i) + (text.size() > kProse ? " prose" : "");
      line += i == 0 ? element("th", {{"scope", "row"}, {"class", css_class}}, text)
                     : element("td", {{"class", css_class}}, text);
    }
    const bool paper = !cells.row_from_paper.empty() && cells.row_from_paper[r];
    body += element("tr", paper ? Attributes{{"class", "paper"}} : Attributes{}, line);
  }
  Markup content = element("caption", caption);
  content += element("thead", Attributes{}, element("tr", Attributes{}, head));
  content += element("tbody", Attributes{}, body);
  return element("div", {{"class", "scroll"}}, element("table", Attributes{}, content));
}

Cells cells_of(const Json& table) {
  Cells cells;
  for (const Json& column : table.at("columns")) {
    cells.headings.push_back(column.at("title"));
    cells.from_paper.push_back(column.at("key").get<std::string>().starts_with("paper"));
  }
  for (const Json& row : table.at("rows")) {
    std::vector<std::string> line;
    for (const Json& column : table.at("columns"))
      line.push_back(cell_text(row.at(column.at("key").get<std::string>()), column.at("decimals")));
    cells.rows.push_back(line);
    cells.row_from_paper.push_back(row.contains("source") && row["source"] == "paper");
  }
  return cells;
}

}  // namespace

std::string cell_text(const Json& cell, int decimals) {
  if (cell.is_null()) return "-";
  if (cell.is_string()) return cell.get<std::string>();
  if (cell.is_number_float()) return fmt::format("{:.{}f}", cell.get<double>(), std::clamp(decimals, 0, 20));
  return cell.dump();
}

std::string count_text(std::uint64_t count) {
  std::string text = std::to_string(count);
  for (std::size_t i = text.size(); i > 3; i -= 3) text.insert(i - 3, 1, ',');
  return text;
}

Markup plain_table(const std::string& caption, const std::vector<std::string>& headings,
                   const std::vector<std::vector<std::string>>& rows) {
  return table_of(caption, {headings, std::vector<bool>(headings.size(), false), rows});
}

Markup result_table(const Json& table) {
  const std::string title = table.at("title");
  Markup markup = element("h3", title);
  const Cells cells = cells_of(table);
  Markup rows = table_of(title, cells);
  if (cells.rows.size() > kLongTable) {
    Markup details = element("summary", fmt::format("{} rows", cells.rows.size()));
    details += rows;
    rows = element("details", {{"class", "long"}}, details);
  }
  markup += rows;
  Markup notes;
  for (const Json& note : table.at("notes")) notes += element("li", note.get<std::string>());
  if (!notes.empty()) markup += element("ul", {{"class", "notes"}}, notes);
  return markup;
}

}  // namespace cbvh::testbench
