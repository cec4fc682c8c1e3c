// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "testbench/eval/rays/measure.h"
#include "testbench/eval/table.h"

namespace cbvh::testbench {

/// Tests a ray of each kind in each scene, and how many more through each compressed tree.
Table ray_tests_table(const std::vector<RaysMeasure>& measures);

/// The averages over all scenes, of each kind of rays and of all, beside the papers' figures.
Table ray_tests_average_table(const std::vector<RaysMeasure>& measures);

}  // namespace cbvh::testbench
