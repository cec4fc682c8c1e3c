// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "testbench/eval/table.h"
#include "testbench/eval/two_level/measure.h"

namespace cbvh::testbench {

/// Quality, size and build time of each top level; ratios to the first one of the same scene and kind of object trees.
Table two_level_table(const std::vector<TopLevelMeasure>& measures);

}  // namespace cbvh::testbench
