// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "testbench/eval/space/measure.h"
#include "testbench/eval/table.h"

namespace cbvh::testbench {

/// Size and costs of each tree over those of the scene's first one, beside the paper's (Tables 1 to 4).
Table space_table(const std::vector<SpaceMeasure>& measures);

/// Steps, tests and costs of a ray in figures of their own.
Table space_rays_table(const std::vector<SpaceMeasure>& measures);

/// Costs of G-BVH over the penalty on overlap (Figure 6, a drawing without numbers).
Table space_overlap_table(const std::vector<SpaceMeasure>& measures);

}  // namespace cbvh::testbench
