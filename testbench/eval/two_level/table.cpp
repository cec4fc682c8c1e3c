// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/eval/two_level/table.h"

#include <algorithm>

namespace cbvh::testbench {

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
       {"sah", "SAH", 2},
       {"sah_ratio", "of the first", 3},
       {"single_ratio", "single tree", 3},
       {"compressed_ratio", "compressed top / float", 4},
       {"backtracks_1", "M D=1", 4},
       {"backtracks_4", "M D=4", 4}},
      3,
      {},
      {"SAH of both levels with C_T = C_I = 1, relative to the box around all instances; of the first: over the "
       "first top level's of the same scene and object trees; single tree: one tree over all triangles, over "
       "the same",
       "Benthin et al. 2017, Table 1, SAH two-level : re-braided : single = 1 : 0.44-0.89 : 0.29-0.85; "
       "section 6.2, time to build a re-braided top level: about 2.5 times that of a plain one",
       "M: backtracks a pair of the top level with modulo codes, treelets of D levels (D=1: none)"},
      true};
  for (const TopLevelMeasure& m : measures) {
    const TopLevelMeasure& first = *std::find_if(measures.begin(), measures.end(), [&](const TopLevelMeasure& other) {
      return other.scene == m.scene && other.objects == m.objects;
    });
    const auto per = [](std::uint64_t a, std::uint64_t b) {
      return b == 0 ? Json() : Json(static_cast<double>(a) / static_cast<double>(b));
    };
    table.rows.push_back({m.scene, m.top, m.objects, m.triangles, m.instances, m.references,
                          per(m.pairs, m.object_pairs), m.depth, m.build_seconds * 1000,
                          m.build_seconds / first.build_seconds, m.sah, m.sah / first.sah,
                          m.sah_single ? Json(*m.sah_single / first.sah) : Json(), m.sah_compressed / m.sah,
                          per(m.modulo.backtracks[0], m.pairs), per(m.modulo.backtracks[kTreeletDepths - 1], m.pairs)});
  }
  return table;
}

}  // namespace cbvh::testbench
