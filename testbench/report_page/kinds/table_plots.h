// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "testbench/report_page/figure.h"
#include "testbench/report_page/result.h"

namespace cbvh::testbench {

/// Draws the table of this key (docs/command.md, "Evaluations"), one of `tables`; nothing when that key has no drawing.
/// Throws nlohmann::json::exception when a column is missing.
Markup draw_table(const std::string& key, const Json& tables, Figures& figures);

}  // namespace cbvh::testbench
