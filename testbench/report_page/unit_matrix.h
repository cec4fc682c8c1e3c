// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "testbench/report_page/result.h"

namespace cbvh::testbench {

/// Units against backends: checks of each over all reports of checks. Units that only a registry names stand there as
/// not checked. Nothing without a report or a registry.
Markup unit_matrix(const std::vector<Result>& results);

}  // namespace cbvh::testbench
