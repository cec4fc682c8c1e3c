// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/rtl/unit_driver.h"

namespace cbvh::testbench {

std::vector<UnitDriver> all_unit_drivers() {
  std::vector<UnitDriver> drivers;
  for (DescribeDriver* describe : all_driver_descriptions()) drivers.push_back(describe());
  return drivers;
}

}  // namespace cbvh::testbench
