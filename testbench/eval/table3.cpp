// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/eval/paper.h"
#include "testbench/eval/sections.h"
#include "testbench/eval/strategy.h"

namespace cbvh::testbench {

std::vector<Table> table3_tables(const std::vector<SceneMeasure>& scenes) {
  Table table{"table3",
              "Table 3: memory traffic of each scene, bytes a primitive",
              {{"scene", "scene"},
               {"update", "update"},
               {"leaf_size", "leaf size", 2},
               {"paper_leaf_size", "the paper's", 1},
               {"update_bytes", "construction or refit", 1},
               {"separate_bytes", "B separate", 1}},
              2,
              {},
              {"total of B: construction or refit + separate compression; of the others: construction or refit + "
               "backtracking",
               "the paper's Table 3 is a drawing, its numbers are not known; of its Table 2 the leaf size is, which "
               "decides the first two parts"},
              true};
  for (const Strategy& strategy : kStrategies) {
    if (strategy.counts != nullptr)
      table.columns.push_back(
          {std::string(strategy.key) + "_backtracking_bytes", std::string(strategy.name) + " backtracking", 1});
  }
  for (const Strategy& strategy : kStrategies)
    table.columns.push_back({std::string(strategy.key) + "_bytes", std::string(strategy.name), 1});
  for (const SceneMeasure& scene : scenes) {
    const PaperCounterpart paper = paper_counterpart(scene);
    for (const Update& update : kUpdates) {
      const TrafficParts baseline = traffic_parts(update, kStrategies[0], scene);
      std::vector<Json> row = {scene.name,        update.key,
                               scene.leaf_size(), paper.same == nullptr ? Json() : Json(paper.same->leaf_size),
                               baseline.update,   baseline.separate};
      for (const Strategy& strategy : kStrategies) {
        if (strategy.counts != nullptr) row.emplace_back(traffic_parts(update, strategy, scene).backtracking);
      }
      for (const Strategy& strategy : kStrategies) row.emplace_back(traffic_parts(update, strategy, scene).total());
      table.rows.push_back(row);
    }
  }
  return {table};
}

}  // namespace cbvh::testbench
