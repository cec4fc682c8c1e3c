// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>
#include <vector>

#include "testbench/backend/responses.h"
#include "testbench/backend/run_options.h"
#include "vectors/vector_set.h"

namespace cbvh::testbench {

/// Runs the C++ module of one unit.
struct UnitDriver {
  std::string_view unit;
  Responses (*run)(const vectors::VectorSet& set, const RunOptions& options);
};

/// Describes one driver. rtl/units/x.cpp defines x_driver and needs no entry anywhere.
using DescribeDriver = UnitDriver();
std::vector<DescribeDriver*> all_driver_descriptions();

std::vector<UnitDriver> all_unit_drivers();

}  // namespace cbvh::testbench
