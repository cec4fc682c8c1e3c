// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/eval/sections.h"

namespace cbvh::testbench {

std::vector<Section> known_sections() {
  std::vector<Section> sections = {{"figure1", figure1_tables}, {"table1", table1_tables}};
  if (runtime_measurement()) sections.push_back({"table2", table2_tables});
  sections.push_back({"table3", table3_tables});
  sections.push_back({"figure7", figure7_tables});
  sections.push_back({"figure10", figure10_tables});
  return sections;
}

}  // namespace cbvh::testbench
