// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "testbench/eval/sections.h"

namespace cbvh::testbench {

namespace {

std::uint64_t at_depth(const CodeCounts& counts, std::size_t depth) {
  return depth < counts.depth_histogram.size() ? counts.depth_histogram[depth] : 0;
}

std::uint64_t at_depth_and_below(const CodeCounts& counts, std::size_t depth) {
  std::uint64_t sum = 0;
  for (std::size_t d = depth; d < counts.depth_histogram.size(); ++d) sum += counts.depth_histogram[d];
  return sum;
}

}  // namespace

std::vector<Table> figure7_tables(const std::vector<SceneMeasure>& scenes) {
  Table table{"figure7",
              "Figure 7: depth of backtracks, without treelets",
              {{"scene", "scene"},
               {"depth", "depth"},
               {"relative", "R"},
               {"modulo", "M"},
               {"relative_below", "R, here and below"},
               {"modulo_below", "M, here and below"}},
              2,
              {},
              {"'here and below' at depth D is what treelets of D levels leave: checked for D = 1..4 against streaming "
               "with such treelets",
               "the paper draws its Elephant, without numbers: both codes top-heavy, as here"},
              true};
  for (const SceneMeasure& scene : scenes) {
    const std::size_t end = std::max(scene.relative.depth_histogram.size(), scene.modulo.depth_histogram.size());
    for (std::size_t depth = 1; depth < end; ++depth)
      table.rows.push_back({scene.name, depth, at_depth(scene.relative, depth), at_depth(scene.modulo, depth),
                            at_depth_and_below(scene.relative, depth), at_depth_and_below(scene.modulo, depth)});
  }
  return {table};
}

}  // namespace cbvh::testbench
