// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "testbench/eval/builders/measure.h"
#include "testbench/eval/table.h"

namespace cbvh::testbench {

/// Size, quality and build time of each tree; ratios to the first builder's of the same scene.
Table builder_trees_table(const std::vector<BuilderMeasure>& measures);

/// What compressing each tree costs: backtracks, and traffic over that of a separate top-down pass.
Table builder_compression_table(const std::vector<BuilderMeasure>& measures);

}  // namespace cbvh::testbench
