// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/eval/two_level/table.h"

#include <algorithm>

namespace cbvh::testbench {

namespace {

Json per(std::uint64_t a, std::uint64_t b) {
  return b == 0 ? Json() : Json(static_cast<double>(a) / static_cast<double>(b));
}

/// What the paper has for such a row: of re-braided top levels over objects in place, or over transformed instances.
Json paper(const TopLevelMeasure& m, const char* in_place, const char* transformed) {
  const bool compares = m.top.starts_with("rebraid") && m.objects == "float";
  const std::string figure = m.transformed ? transformed : in_place;
  return compares && !figure.empty() ? Json(figure) : Json();
}

}  // namespace

Table two_level_table(const std::vector<TopLevelMeasure>& measures) {
  Table table{
      "two_level",
      "Top levels over instances",
      {{"scene", "scene"},
       {"top", "top level"},
       {"objects", "object trees"},
       {"triangles", "triangles"},
       {"instances", "instances"},
       {"references", "references"},
       {"pairs_ratio", "pairs / objects' pairs", 4},
       {"depth", "depth"},
       {"build_ms", "build ms", 3},
       {"build_ratio", "of the first", 2},
       {"paper_build_ratio", "paper"},
       {"total_ratio", "with objects", 3},
       {"paper_total_ratio", "paper"},
       {"single_build_ratio", "single tree", 2},
       {"paper_single_build_ratio", "paper"},
       {"sah", "SAH", 2},
       {"sah_ratio", "of the first", 3},
       {"paper_sah_ratio", "paper"},
       {"single_ratio", "single tree", 3},
       {"paper_single_ratio", "paper"},
       {"compressed_ratio", "compressed top / float", 4},
       {"backtracks_1", "M D=1", 4},
       {"backtracks_4", "M D=4", 4}},
      3,
      {},
      {"SAH of both levels with C_T = C_I = 1, relative to the box around all instances; of the first: over the "
       "first top level's of the same scene and object trees; single tree: one tree over all triangles, over "
       "the same",
       "with objects: the objects' trees and the top level, over the same with the first top level; single tree: one "
       "tree over all triangles, over the same",
       "paper: Benthin et al. 2017 (with space=4 or triangles=1000), Tables 1 and 2, re-braided and single over "
       "two-level: of the five scenes of "
       "objects in place the range, of Trees, the only one of transformed instances, its value. Their plain top level "
       "ran on 36 cores: 1 ms for 253 objects, 15 ms for 12,000 instances",
       "M: backtracks a pair of the top level with modulo codes, treelets of D levels (D=1: none)"},
      true};
  for (const TopLevelMeasure& m : measures) {
    const TopLevelMeasure& first = *std::find_if(measures.begin(), measures.end(), [&](const TopLevelMeasure& other) {
      return other.scene == m.scene && other.objects == m.objects;
    });
    const double first_total = first.objects_seconds + first.build_seconds;
    table.rows.push_back({m.scene,
                          m.top,
                          m.objects,
                          m.triangles,
                          m.instances,
                          m.references,
                          per(m.pairs, m.object_pairs),
                          m.depth,
                          m.build_seconds * 1000,
                          m.build_seconds / first.build_seconds,
                          paper(m, "2.2-3.3", "2.0"),
                          (m.objects_seconds + m.build_seconds) / first_total,
                          paper(m, "1.00-1.03", "1.12"),
                          m.single_seconds ? Json(*m.single_seconds / first_total) : Json(),
                          paper(m, "1.6-4.0", ""),
                          m.sah,
                          m.sah / first.sah,
                          paper(m, "0.44-0.89", "0.92"),
                          m.sah_single ? Json(*m.sah_single / first.sah) : Json(),
                          paper(m, "0.29-0.85", ""),
                          m.sah_compressed / m.sah,
                          per(m.modulo.backtracks[0], m.pairs),
                          per(m.modulo.backtracks[kTreeletDepths - 1], m.pairs)});
  }
  return table;
}

}  // namespace cbvh::testbench
