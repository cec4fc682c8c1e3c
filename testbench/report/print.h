// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "testbench/report/report.h"

namespace cbvh::testbench {

/// Unit, set, case, response, field, found, wanted and the command that reruns it; lines without a final line feed.
std::string to_string(const Mismatch& mismatch);

/// One line: unit, set, cases, checks, failures, cases a second.
std::string to_string(const SetReport& set);

/// The whole report as `cbvh` prints it. The last line is "N passed, M failed".
std::string to_string(const Report& report);

}  // namespace cbvh::testbench
