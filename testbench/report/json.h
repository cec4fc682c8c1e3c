// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "testbench/report/report.h"

namespace cbvh::testbench {

/// Objects keep the order their keys were written in.
using Json = nlohmann::ordered_json;

/// The report and its verdict. Keys are stable: other programs read them.
Json to_json(const Report& report);

/// Reads back what to_json wrote. Throws InputError with `place` when it is something else.
Report report_from_json(const std::string& text, const std::string& place);

}  // namespace cbvh::testbench
