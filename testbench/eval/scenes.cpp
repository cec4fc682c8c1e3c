// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/eval/paper.h"
#include "testbench/eval/sections.h"

namespace cbvh::testbench {

Table scenes_table(const std::vector<SceneMeasure>& scenes) {
  Table table{"scenes", "Scenes", {{"scene", "scene"}, {"triangles", "triangles"}, {"leaves", "leaves"}}, 1, {},
              {},       true};
  table.columns.insert(table.columns.end(), {{"pairs", "pairs"},
                                             {"leaf_size", "leaf size", 2},
                                             {"paper_leaf_size", "the paper's", 1},
                                             {"min_scale", "e_min"},
                                             {"sah_ratio", "SAH quantized / float", 3}});
  for (const char code : {'r', 'm'}) {
    for (std::size_t depth = 1; depth <= kTreeletDepths; ++depth) {
      const std::string number = std::to_string(depth);
      table.columns.push_back({std::string(code == 'r' ? "relative_" : "modulo_") + number,
                               std::string(code == 'r' ? "R D=" : "M D=") + number});
    }
  }
  table.columns.push_back({"note", "note"});
  for (const SceneMeasure& scene : scenes) {
    const PaperCounterpart paper = paper_counterpart(scene);
    std::vector<Json> row = {scene.name, scene.triangles, scene.leaves, scene.pairs, scene.leaf_size()};
    row.push_back(paper.same == nullptr ? Json() : Json(paper.same->leaf_size));
    row.insert(row.end(), {scene.min_scale, scene.sah_quantized / scene.sah_float});
    for (const CodeCounts* counts : {&scene.relative, &scene.modulo})
      row.insert(row.end(), counts->backtracks.begin(), counts->backtracks.end());
    row.push_back(paper.note.empty() ? Json() : Json(paper.note));
    table.rows.push_back(row);
  }
  table.notes = {
      "leaf size: triangles a leaf; R, M: backtracks with relative and modulo codes, treelets of D levels (D=1: none)"};
  return table;
}

}  // namespace cbvh::testbench
