// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/trace/hits/hits_report.h"

#include <fmt/format.h>

namespace cbvh::testbench {

namespace {

constexpr std::array<const char*, kHitRelations> kTitles = {"both nothing",  "same triangle",   "equal distance",
                                                            "Embree rounds", "distance rounds", "lost",
                                                            "not hit",       "wrong distance"};

std::vector<Json> row(const std::string& scene, const HitsResult& result) {
  std::vector<Json> cells = {scene, result.set, result.rays};
  for (const std::uint64_t count : result.relations) cells.emplace_back(count);
  cells.emplace_back(result.tree_differences);
  return cells;
}

}  // namespace

Table hits_table(const std::string& scene, const std::vector<HitsResult>& results) {
  Table table{"embree_hits",
              "Nearest hits against Embree's",
              {{"scene", "scene"}, {"set", "rays"}, {"count", "count"}},
              2,
              {},
              {"who is right is decided in exact integers; lost: Embree's triangle is hit exactly and nearer than ours",
               "other tree: another hit through the compressed tree than through the float tree"},
              true};
  for (std::size_t i = 0; i < kHitRelations; ++i) table.columns.push_back({kHitRelationNames[i], kTitles[i]});
  table.columns.push_back({"tree_differences", "other tree"});
  HitsResult all;
  all.set = "all";
  for (const HitsResult& result : results) {
    table.rows.push_back(row(scene, result));
    all.rays += result.rays;
    all.tree_differences += result.tree_differences;
    for (std::size_t i = 0; i < kHitRelations; ++i) all.relations[i] += result.relations[i];
  }
  table.rows.push_back(row(scene, all));
  return table;
}

HitsSummary summary_of(const std::string& scene, const std::vector<HitsResult>& results) {
  std::uint64_t rays = 0;
  std::uint64_t wrong = 0;
  std::vector<std::string> failures;
  for (const HitsResult& result : results) {
    rays += result.rays;
    wrong += result.wrong();
    for (const std::string& mistake : result.mistakes) failures.push_back(fmt::format("{}: {}", result.set, mistake));
  }
  const Table table = hits_table(scene, results);
  HitsSummary summary;
  summary.json = {{"checks", 2 * rays}, {"failures", failures}, {"tables", {{table.key, to_json(table)}}}};
  summary.text = to_markdown(table);
  for (const std::string& failure : failures) summary.text += fmt::format("FAILED: {}\n", failure);
  summary.text += fmt::format("{} rays, {} mistakes\n", rays, wrong);
  summary.pass = wrong == 0 && rays > 0;
  return summary;
}

}  // namespace cbvh::testbench
