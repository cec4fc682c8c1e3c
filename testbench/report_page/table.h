// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "testbench/report/json.h"
#include "testbench/report_page/markup.h"

namespace cbvh::testbench {

/// A table of texts; the first cell of a row names it. Columns of numbers alone are flushed right. `caption` is for who
/// does not see the page.
Markup plain_table(const std::string& caption, const std::vector<std::string>& headings,
                   const std::vector<std::vector<std::string>>& rows);

/// A table as to_json(Table) writes it (testbench/eval/table.h): heading, rows as the text rounds them, notes. The
/// paper's own figures are set apart; long tables unfold. Throws nlohmann::json::exception when the JSON is not such a
/// table.
Markup result_table(const Json& table);

/// With commas between thousands.
std::string count_text(std::uint64_t count);

/// A cell as the text has it: numbers that are not integers with `decimals`, "-" for null.
std::string cell_text(const Json& cell, int decimals);

}  // namespace cbvh::testbench
