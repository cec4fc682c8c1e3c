// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/eval/builders/tables.h"

#include <algorithm>

#include "golden/update/traffic.h"

namespace cbvh::testbench {

namespace {

const BuilderMeasure& first_of_scene(const std::vector<BuilderMeasure>& measures, const std::string& scene) {
  return *std::find_if(measures.begin(), measures.end(),
                       [&](const BuilderMeasure& measure) { return measure.scene == scene; });
}

double per_pair(std::uint64_t count, const BuilderMeasure& measure) {
  return measure.pairs == 0 ? 0 : static_cast<double>(count) / static_cast<double>(measure.pairs);
}

}  // namespace

Table builder_trees_table(const std::vector<BuilderMeasure>& measures) {
  Table table{"builder_trees",
              "Builders: the trees",
              {{"scene", "scene"},
               {"builder", "builder"},
               {"triangles", "triangles"},
               {"references", "references"},
               {"leaves", "leaves"},
               {"depth", "depth"},
               {"build_seconds", "build s", 4},
               {"build_ratio", "of the first", 2},
               {"sah_float", "SAH", 2},
               {"sah_of_first", "of the first", 3},
               {"sah_quantized_ratio", "quantized / float", 4}},
              2,
              {},
              {"SAH with C_T = C_I = 1, relative to the scene's box; quantized: N = 6",
               "of the first: over that builder's figure for the same scene"},
              true};
  for (const BuilderMeasure& m : measures) {
    const BuilderMeasure& first = first_of_scene(measures, m.scene);
    table.rows.push_back({m.scene, m.builder, m.triangles, m.references, m.leaves, m.depth, m.build_seconds,
                          m.build_seconds / first.build_seconds, m.sah_float, m.sah_float / first.sah_float,
                          m.sah_quantized / m.sah_float});
  }
  return table;
}

Table builder_compression_table(const std::vector<BuilderMeasure>& measures) {
  Table table{
      "builder_compression",
      "Builders: backtracks and traffic of compressing",
      {{"scene", "scene"}, {"builder", "builder"}, {"pairs", "pairs"}},
      2,
      {},
      {"R, M: backtracks a pair with relative and modulo codes, treelets of D levels (D=1: none)",
       "traffic: bytes with modulo codes and D=4 over a float tree written, read and compressed top-down; build "
       "and refit as in the paper's section 5.2, a reference for a primitive; B: these bytes, a triangle"},
      true};
  for (const char code : {'r', 'm'}) {
    for (std::size_t depth = 1; depth <= kTreeletDepths; ++depth) {
      const std::string number = std::to_string(depth);
      table.columns.push_back({std::string(code == 'r' ? "relative_" : "modulo_") + number,
                               std::string(code == 'r' ? "R D=" : "M D=") + number, 5});
    }
  }
  table.columns.push_back({"build_traffic_ratio", "build traffic", 3});
  table.columns.push_back({"refit_traffic_ratio", "refit traffic", 3});
  table.columns.push_back({"build_bytes", "build B", 1});
  table.columns.push_back({"refit_bytes", "refit B", 1});
  for (const BuilderMeasure& m : measures) {
    std::vector<Json> row = {m.scene, m.builder, m.pairs};
    for (const CodeCounts* counts : {&m.relative, &m.modulo}) {
      for (const std::uint64_t backtracks : counts->backtracks) row.emplace_back(per_pair(backtracks, m));
    }
    const golden::UpdateTraffic traffic =
        golden::update_traffic(m.references, m.pairs, m.modulo.backtracks[kTreeletDepths - 1]);
    row.emplace_back(traffic.lbvh.ratio());
    row.emplace_back(traffic.refit.ratio());
    for (const golden::Traffic& way : {traffic.lbvh, traffic.refit}) {
      row.emplace_back(static_cast<double>(way.streaming_bytes) / static_cast<double>(m.triangles));
    }
    table.rows.push_back(row);
  }
  return table;
}

}  // namespace cbvh::testbench
