// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>

#include "testbench/eval/sections.h"
#include "testbench/eval/spread.h"

namespace cbvh::testbench {

namespace {

bool is_cloth(const SceneMeasure& scene) { return scene.name.find("cloth") != std::string::npos; }

Json scale_label(const SweepPoint& point) {
  return point.min_scale ? std::to_string(*point.min_scale) : std::string("auto");
}

double per_primitive(std::uint64_t count, const SceneMeasure& scene) {
  return static_cast<double>(count) / static_cast<double>(scene.triangles);
}

/// The scene's SAH at one scale over the least of its sweep.
double quality(const SceneMeasure& scene, std::size_t point) {
  double best = scene.sweep[0].sah;
  for (const SweepPoint& other : scene.sweep) best = std::min(best, other.sah);
  return scene.sweep[point].sah / best;
}

/// Backtracks a primitive without treelets and with 4 levels, and the SAH: averages of some scenes, or three times
/// nothing.
void append_averages(std::vector<Json>& row, const std::vector<const SceneMeasure*>& scenes, std::size_t point) {
  std::array<std::vector<double>, 3> values;
  for (const SceneMeasure* scene : scenes) {
    values[0].push_back(per_primitive(scene->sweep[point].one_level, *scene));
    values[1].push_back(per_primitive(scene->sweep[point].four_levels, *scene));
    values[2].push_back(quality(*scene, point));
  }
  for (const auto& figures : values) row.push_back(scenes.empty() ? Json() : Json(average(figures)));
}

}  // namespace

std::vector<Table> figure10_tables(const std::vector<SceneMeasure>& scenes) {
  Table summary{"figure10",
                "Figure 10: minimum scale, modulo codes: backtracks a primitive, SAH of the best",
                {{"min_scale", "e_min"},
                 {"cloth_backtracks_1", "cloth D=1", 4},
                 {"cloth_backtracks_4", "cloth D=4", 4},
                 {"cloth_sah", "cloth SAH", 4},
                 {"others_backtracks_1", "others D=1", 4},
                 {"others_backtracks_4", "others D=4", 4},
                 {"others_sah", "others SAH", 4}},
                1,
                {},
                {"others: their average; 'cloth' is in the name of the cloth's scene",
                 "the paper (a drawing): cloth backtracks much below 2^-30, trees get worse above 2^-15; e_min is in "
                 "the scene's own units, so another scene's margin lies elsewhere"},
                true};
  Table each{"figure10_scenes",
             "Figure 10: each scene",
             {{"scene", "scene"},
              {"min_scale", "e_min"},
              {"backtracks_1", "M D=1"},
              {"backtracks_4", "M D=4"},
              {"sah", "SAH", 6},
              {"sah_of_best", "of the best", 4}},
             2,
             {},
             {},
             false};
  std::vector<const SceneMeasure*> cloth;
  std::vector<const SceneMeasure*> others;
  for (const SceneMeasure& scene : scenes) (is_cloth(scene) ? cloth : others).push_back(&scene);
  for (std::size_t i = 0; i < scenes[0].sweep.size(); ++i) {
    std::vector<Json> row = {scale_label(scenes[0].sweep[i])};
    append_averages(row, cloth, i);
    append_averages(row, others, i);
    summary.rows.push_back(row);
  }
  for (const SceneMeasure& scene : scenes) {
    for (std::size_t i = 0; i < scene.sweep.size(); ++i) {
      const SweepPoint& point = scene.sweep[i];
      each.rows.push_back(
          {scene.name, scale_label(point), point.one_level, point.four_levels, point.sah, quality(scene, i)});
    }
  }
  return {summary, each};
}

}  // namespace cbvh::testbench
