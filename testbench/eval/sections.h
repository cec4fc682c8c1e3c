// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "testbench/eval/measure.h"
#include "testbench/eval/table.h"

namespace cbvh::testbench {

/// A part of an evaluation: a table or figure of the paper, for scenes of ours.
struct Section {
  std::string name;
  std::vector<Table> (*tables)(const std::vector<SceneMeasure>& scenes);
};

/// Those this build can make, in order; Table 2 only with a runtime_measurement().
std::vector<Section> known_sections();

// What the sections consist of. `scenes` is never empty.
Table scenes_table(const std::vector<SceneMeasure>& scenes);  ///< of every evaluation
std::vector<Table> figure1_tables(const std::vector<SceneMeasure>& scenes);
std::vector<Table> table1_tables(const std::vector<SceneMeasure>& scenes);
std::vector<Table> table2_tables(const std::vector<SceneMeasure>& scenes);  ///< all have been given a runtime
std::vector<Table> table3_tables(const std::vector<SceneMeasure>& scenes);
std::vector<Table> figure7_tables(const std::vector<SceneMeasure>& scenes);
std::vector<Table> figure10_tables(const std::vector<SceneMeasure>& scenes);  ///< all have the same sweep

}  // namespace cbvh::testbench
