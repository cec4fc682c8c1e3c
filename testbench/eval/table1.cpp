// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <functional>

#include "testbench/eval/paper.h"
#include "testbench/eval/sections.h"
#include "testbench/eval/spread.h"
#include "testbench/eval/strategy.h"

namespace cbvh::testbench {

namespace {

/// A figure of a scene with so many backtracks.
using Figure = std::function<double(const SceneMeasure& scene, std::uint64_t backtracks)>;

/// Eight rows: both codes, each with treelets of 1 to 4 levels.
void add_quantity(Table& table, const char* quantity, const std::vector<SceneMeasure>& scenes, const Figure& figure,
                  const PaperSpread& paper) {
  for (std::size_t i = 0; i < std::size(paper.least); ++i) {
    const bool relative = i < kTreeletDepths;
    const std::size_t depth = i % kTreeletDepths;
    std::vector<double> values;
    values.reserve(scenes.size());
    for (const SceneMeasure& scene : scenes)
      values.push_back(figure(scene, (relative ? scene.relative : scene.modulo).backtracks[depth]));
    const Spread spread = spread_of(values);
    table.rows.push_back({quantity, relative ? "relative" : "modulo", depth + 1, spread.average, paper.average[i],
                          spread.least, paper.least[i], spread.most, paper.most[i]});
  }
}

double normalized_backtracks(const SceneMeasure& scene, std::uint64_t backtracks) {
  return static_cast<double>(backtracks) / static_cast<double>(scene.relative.backtracks[0]);
}

Figure traffic_ratio(const Update& update) {
  return [update](const SceneMeasure& scene, std::uint64_t backtracks) {
    return (golden::update_traffic(scene.triangles, scene.pairs, backtracks).*update.traffic).ratio();
  };
}

/// What the byte counts give for the paper's own leaf sizes, were there no backtracks.
std::string paper_leaf_sizes_note() {
  std::array<std::vector<double>, kUpdates.size()> ratios;
  for (const PaperScene& scene : paper_scenes()) {
    constexpr std::uint64_t kPairs = 1000;
    const auto primitives = static_cast<std::uint64_t>(std::lround(scene.leaf_size * static_cast<double>(kPairs)));
    for (std::size_t i = 0; i < ratios.size(); ++i)
      ratios[i].push_back((golden::update_traffic(primitives, kPairs, 0).*kUpdates[i].traffic).ratio());
  }
  const Spread lbvh = spread_of(ratios[0]);
  const Spread refit = spread_of(ratios[1]);
  return fmt::format(
      "the same byte counts on the leaf sizes of the paper's Table 2, without any backtrack: LBVH {:.2f} on average, "
      "{:.2f} at most; refit {:.2f}, {:.2f}",
      lbvh.average, lbvh.most, refit.average, refit.most);
}

}  // namespace

std::vector<Table> table1_tables(const std::vector<SceneMeasure>& scenes) {
  Table table{"table1",
              "Table 1: backtracks per those of R D=1, traffic per that of separate top-down compression",
              {{"quantity", "quantity"},
               {"code", "code"},
               {"treelet", "D"},
               {"average", "average", 3},
               {"paper_average", "the paper's", 2},
               {"min", "min", 3},
               {"paper_min", "the paper's", 2},
               {"max", "max", 3},
               {"paper_max", "the paper's", 2}},
              3,
              {},
              {},
              true};
  std::vector<SceneMeasure> counted;
  for (const SceneMeasure& scene : scenes) {
    if (scene.relative.backtracks[0] > 0) counted.push_back(scene);
  }
  if (!counted.empty()) add_quantity(table, "backtracks", counted, normalized_backtracks, kPaperBacktracks);
  add_quantity(table, "lbvh_traffic", scenes, traffic_ratio(kUpdates[0]), kPaperLbvhTraffic);
  add_quantity(table, "refit_traffic", scenes, traffic_ratio(kUpdates[1]), kPaperRefitTraffic);
  table.notes.push_back(
      fmt::format("measured over {} scenes, each weighing the same; the paper's over its 16", scenes.size()));
  table.notes.push_back(paper_leaf_sizes_note());
  if (counted.size() != scenes.size())
    table.notes.push_back(fmt::format("{} scenes have no backtracks to normalize to and are left out of those rows",
                                      scenes.size() - counted.size()));
  return {table};
}

}  // namespace cbvh::testbench
