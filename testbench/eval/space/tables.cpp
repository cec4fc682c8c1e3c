// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/eval/space/tables.h"

#include <algorithm>

namespace cbvh::testbench {

namespace {

const SpaceMeasure& first_of_scene(const std::vector<SpaceMeasure>& measures, const std::string& scene) {
  return *std::find_if(measures.begin(), measures.end(),
                       [&](const SpaceMeasure& measure) { return measure.scene == scene; });
}

Json figure(const std::optional<double>& value) { return value ? Json(*value) : Json(); }

double ratio(std::uint64_t a, std::uint64_t b) { return static_cast<double>(a) / static_cast<double>(b); }

}  // namespace

Table space_table(const std::vector<SpaceMeasure>& measures) {
  Table table{"space",
              "Space subdivision: size and cost over the first tree's",
              {{"scene", "scene"},
               {"tree", "tree"},
               {"reference_ratio", "references a triangle", 2},
               {"size_ratio", "size", 2},
               {"paper_size_ratio", "paper", 2},
               {"expected_ratio", "Exp(T)", 3},
               {"paper_expected_ratio", "paper", 3},
               {"terminating_ratio", "ray, early termination", 3},
               {"paper_terminating_ratio", "paper", 3},
               {"through_ratio", "ray, without", 3},
               {"paper_through_ratio", "paper", 3},
               {"build_seconds", "build s", 2}},
              2,
              {},
              {"costs with C_T = 1, C_I = 1.5; size: float node pairs of 64 bytes, references of 4",
               "early termination: rays from anywhere within the scene's box, to the nearest hit; without: rays across "
               "the box that nothing stops",
               "paper: random rays (Tables 3 and 4); of recursive cost evaluation, EVH, ESC and the rotated scene "
               "primary rays (Tables 1 and 2); SS-BVH of scenes not rotated: GK-BVH's figures, as section 5.1 says; "
               "its thresholds 80 and 200 are in units of its scene"},
              true};
  for (const SpaceMeasure& m : measures) {
    const SpaceMeasure& first = first_of_scene(measures, m.scene);
    const PaperSpaceRatios paper = paper_space_ratios(m.scene, m.tree);
    table.rows.push_back({m.scene, m.tree, ratio(m.references, m.triangles), ratio(m.bytes, first.bytes),
                          figure(paper.size), m.expected / first.expected, figure(paper.expected),
                          m.terminating.cost() / first.terminating.cost(), figure(paper.terminating),
                          m.through.cost() / first.through.cost(), figure(paper.through), m.build_seconds});
  }
  return table;
}

Table space_rays_table(const std::vector<SpaceMeasure>& measures) {
  Table table{"space_rays",
              "Space subdivision: what a ray costs",
              {{"scene", "scene"},
               {"tree", "tree"},
               {"builder", "builder"},
               {"triangles", "triangles"},
               {"references", "references"},
               {"depth", "depth"},
               {"expected", "Exp(T)", 1},
               {"terminating_steps", "steps", 1},
               {"terminating_tests", "tests", 1},
               {"terminating_cost", "cost, early termination", 1},
               {"through_steps", "steps", 1},
               {"through_tests", "tests", 1},
               {"through_cost", "cost, without", 1}},
              2,
              {},
              {"steps: inner nodes visited by a ray; tests: triangles; both on average"},
              true};
  for (const SpaceMeasure& m : measures) {
    table.rows.push_back({m.scene, m.tree, m.builder, m.triangles, m.references, m.depth, m.expected,
                          m.terminating.traversal, m.terminating.intersection, m.terminating.cost(),
                          m.through.traversal, m.through.intersection, m.through.cost()});
  }
  return table;
}

Table space_overlap_table(const std::vector<SpaceMeasure>& measures) {
  Table table{"space_overlap",
              "Space subdivision: G-BVH over the penalty on overlap",
              {{"scene", "scene"},
               {"tree", "penalty"},
               {"overlap", "C_O", 0},
               {"reference_ratio", "references a triangle", 2},
               {"expected", "Exp(T)", 1},
               {"expected_ratio", "of the first", 3},
               {"terminating_cost", "cost, early termination", 1},
               {"terminating_ratio", "of the first", 3},
               {"through_cost", "cost, without", 1},
               {"through_ratio", "of the first", 3}},
              2,
              {},
              {"after the paper's Figure 6, which is a drawing without numbers; all three oracles"},
              true};
  for (const SpaceMeasure& m : measures) {
    const SpaceMeasure& first = first_of_scene(measures, m.scene);
    table.rows.push_back({m.scene, m.tree, m.overlap, ratio(m.references, m.triangles), m.expected,
                          m.expected / first.expected, m.terminating.cost(),
                          m.terminating.cost() / first.terminating.cost(), m.through.cost(),
                          m.through.cost() / first.through.cost()});
  }
  return table;
}

}  // namespace cbvh::testbench
