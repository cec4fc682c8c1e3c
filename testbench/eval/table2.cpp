// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/eval/paper.h"
#include "testbench/eval/sections.h"
#include "testbench/eval/spread.h"

namespace cbvh::testbench {

namespace {

using Runtimes = std::array<double, kRuntimes>;

constexpr std::array<const char*, kRuntimes> kKeys = {"float", "top_down", "relative", "modulo_4"};
constexpr std::array<const char*, kRuntimes> kNames = {"float BVH", "+ top-down pass", "streaming R",
                                                       "streaming M D=4"};
constexpr double kShareOfMark = 0.05;

std::vector<Json> to_row(std::vector<Json> row, const Runtimes& values) {
  row.insert(row.end(), values.begin(), values.end());
  return row;
}

/// Over the float build's.
Runtimes normalized(const Runtimes& milliseconds) {
  Runtimes values{};
  for (std::size_t i = 0; i < kRuntimes; ++i) values[i] = milliseconds[i] / milliseconds[0];
  return values;
}

std::vector<Column> runtime_columns(std::vector<Column> columns, const std::string& suffix, int decimals) {
  for (std::size_t i = 0; i < kRuntimes; ++i) columns.push_back({kKeys[i] + suffix, kNames[i], decimals});
  return columns;
}

Table milliseconds_table(const std::vector<SceneMeasure>& scenes) {
  Table table{"table2",
              "Table 2: LBVH runtime at 1 GHz, milliseconds",
              runtime_columns({{"scene", "scene"}, {"source", "source"}}, "_ms", 3),
              2,
              {},
              {"a paper's row stands only under a scene that is the paper's own"},
              true};
  table.columns.push_back({"leaf_size", "leaf size", 2});
  for (const SceneMeasure& scene : scenes) {
    table.rows.push_back(to_row({scene.name, "measured"}, scene.runtime->milliseconds));
    table.rows.back().emplace_back(scene.runtime->leaf_size);
    const PaperCounterpart paper = paper_counterpart(scene);
    if (paper.same == nullptr) continue;
    table.rows.push_back(to_row({scene.name, "paper"}, paper.same->milliseconds));
    table.rows.back().emplace_back(paper.same->leaf_size);
  }
  return table;
}

Table bound_table(const std::vector<SceneMeasure>& scenes) {
  Table table{"table2_bound",
              "Table 2: cycles over those the traffic needs at the memory's peak rate",
              runtime_columns({{"scene", "scene"}}, "_over_bound", 3),
              1,
              {},
              {},
              true};
  for (const SceneMeasure& scene : scenes) table.rows.push_back(to_row({scene.name}, scene.runtime->over_dram_bound));
  return table;
}

/// The averages of Table 2 and the bars of Figure 11.
Table normalized_table(const std::vector<SceneMeasure>& scenes) {
  Table table{"figure11",
              "Figure 11: LBVH runtime over the float build's",
              {{"configuration", "configuration"},
               {"average", "average", 3},
               {"min", "min", 3},
               {"max", "max", 3},
               {"paper_average", "the paper's average", 2},
               {"bar", "average, a mark for 5 %", 0, true}},
              1,
              {},
              {},
              true};
  for (std::size_t i = 0; i < kRuntimes; ++i) {
    std::vector<double> values;
    values.reserve(scenes.size());
    for (const SceneMeasure& scene : scenes) values.push_back(normalized(scene.runtime->milliseconds)[i]);
    const Spread spread = spread_of(values);
    table.rows.push_back({kNames[i], spread.average, spread.least, spread.most, kPaperAverageRuntime[i],
                          bar('=', spread.average, kShareOfMark)});
  }
  return table;
}

/// All of the paper's rows.
Table paper_table() {
  Table table{"table2_paper",
              "Table 2 as the paper has it, milliseconds",
              runtime_columns({{"scene", "scene"}}, "_ms", 1),
              1,
              {},
              {},
              true};
  table.columns.push_back({"leaf_size", "leaf size", 1});
  for (const PaperScene& scene : paper_scenes()) {
    table.rows.push_back(to_row({scene.name}, scene.milliseconds));
    table.rows.back().emplace_back(scene.leaf_size);
  }
  return table;
}

}  // namespace

std::vector<Table> table2_tables(const std::vector<SceneMeasure>& scenes) {
  return {milliseconds_table(scenes), normalized_table(scenes), bound_table(scenes), paper_table()};
}

}  // namespace cbvh::testbench
