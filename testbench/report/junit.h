// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "testbench/report/report.h"

namespace cbvh::testbench {

/// JUnit XML: one test case a unit and set; the failures carry the first mismatches. Coverage is a test case of its
/// own.
std::string to_junit(const Report& report);

/// Text as it may stand in an XML attribute or element. Characters that XML cannot hold become '?'.
std::string xml_escape(const std::string& text);

}  // namespace cbvh::testbench
