// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// The evaluation's tables from counts made by hand; every expected figure was worked out on paper from the byte counts
// of the paper's section 5.2.
#include <gtest/gtest.h>

#include "testbench/eval/paper.h"
#include "testbench/eval/sections.h"

namespace cbvh::testbench {
namespace {

/// 100 triangles in 51 leaves: with 50 pairs LBVH moves 100 * 108 + 50 * 16 = 11600 B, refit 100 * 44 + 50 * 32 = 6000
/// B, and a separate compression adds 50 * 128 = 6400 B.
SceneMeasure hundred() {
  SceneMeasure scene;
  scene.name = "hundred";
  scene.triangles = 100;
  scene.leaves = 51;
  scene.pairs = 50;
  scene.sah_float = 10;
  scene.sah_quantized = 11;
  scene.relative = {{40, 8, 2, 0}, {0, 32, 6, 2}};
  scene.modulo = {{10, 2, 0, 0}, {0, 8, 2}};
  return scene;
}

/// One leaf of 10 triangles: nothing to compress, nothing to repair.
SceneMeasure one_leaf() {
  SceneMeasure scene;
  scene.name = "one_leaf";
  scene.triangles = 10;
  scene.leaves = 1;
  scene.sah_float = 10;
  scene.sah_quantized = 10;
  return scene;
}

/// The row whose labels are given; fails when there is not exactly one.
Json row_of(const Table& table, const std::vector<Json>& labels) {
  Json found;
  for (const auto& row : table.rows) {
    EXPECT_EQ(row.size(), table.columns.size());
    if (!std::equal(labels.begin(), labels.end(), row.begin())) continue;
    EXPECT_TRUE(found.is_null()) << "two rows";
    for (std::size_t i = 0; i < row.size(); ++i) found[table.columns[i].key] = row[i];
  }
  EXPECT_FALSE(found.is_null()) << Json(labels).dump();
  return found;
}

double number(const Json& row, const char* key) { return row.at(key).get<double>(); }

TEST(EvalTables, figure_1_stacks_bytes_a_primitive) {
  const Table table = figure1_tables({hundred()}).at(0);
  ASSERT_EQ(table.rows.size(), 2U * (2 + 5));
  Json row = row_of(table, {"one primitive a leaf", "lbvh", "B"});
  EXPECT_EQ(number(row, "separate_bytes"), 128);
  EXPECT_EQ(number(row, "update_bytes"), 124);
  EXPECT_EQ(number(row, "total_bytes"), 252);
  row = row_of(table, {"one primitive a leaf", "refit", "streaming"});
  EXPECT_EQ(number(row, "total_bytes"), 76);
  EXPECT_DOUBLE_EQ(number(row, "ratio"), 76.0 / 204);
  row = row_of(table, {"average of the scenes", "lbvh", "R0"});
  EXPECT_DOUBLE_EQ(number(row, "separate_bytes"), 0);
  EXPECT_DOUBLE_EQ(number(row, "update_bytes"), 116);
  EXPECT_DOUBLE_EQ(number(row, "backtracking_bytes"), 51.2);  // 40 * 128 / 100
  EXPECT_DOUBLE_EQ(number(row, "ratio"), 167.2 / 180);
  row = row_of(table, {"average of the scenes", "refit", "M1"});
  EXPECT_DOUBLE_EQ(number(row, "backtracking_bytes"), 2.56);
  EXPECT_DOUBLE_EQ(number(row, "total_bytes"), 62.56);
  EXPECT_EQ(row.at("bar").get<std::string>(), "========");  // 60 / 8 rounds to 8, 2.56 / 8 to none
}

TEST(EvalTables, table_1_averages_ratios_and_leaves_out_what_cannot_be_normalized) {
  const Table table = table1_tables({hundred(), one_leaf()}).at(0);
  ASSERT_EQ(table.rows.size(), 3U * 8);
  Json row = row_of(table, {"backtracks", "relative", 2});
  EXPECT_DOUBLE_EQ(number(row, "average"), 0.2);
  EXPECT_EQ(number(row, "paper_average"), 0.15);
  row = row_of(table, {"backtracks", "modulo", 1});
  EXPECT_DOUBLE_EQ(number(row, "max"), 0.25);
  EXPECT_EQ(number(row, "paper_max"), 0.44);
  row = row_of(table, {"lbvh_traffic", "modulo", 1});
  EXPECT_DOUBLE_EQ(number(row, "min"), 12880.0 / 18000);
  EXPECT_DOUBLE_EQ(number(row, "max"), 1);
  EXPECT_DOUBLE_EQ(number(row, "average"), (12880.0 / 18000 + 1) / 2);
  row = row_of(table, {"refit_traffic", "relative", 3});
  EXPECT_DOUBLE_EQ(number(row, "min"), 6256.0 / 12400);
  EXPECT_EQ(number(row, "paper_min"), 0.39);
  ASSERT_EQ(table.notes.size(), 3U);
  EXPECT_NE(table.notes[1].find("LBVH 0.61 on average, 0.88 at most; refit 0.46, 0.76"), std::string::npos)
      << table.notes[1];
  EXPECT_EQ(table1_tables({one_leaf()}).at(0).rows.size(), 2U * 8);
}

TEST(EvalTables, table_3_has_three_parts_of_each_strategy) {
  const Table table = table3_tables({hundred(), one_leaf()}).at(0);
  ASSERT_EQ(table.rows.size(), 2U * 2);
  Json row = row_of(table, {"hundred", "refit"});
  EXPECT_DOUBLE_EQ(number(row, "update_bytes"), 60);
  EXPECT_DOUBLE_EQ(number(row, "separate_bytes"), 64);
  EXPECT_DOUBLE_EQ(number(row, "r1_backtracking_bytes"), 10.24);
  EXPECT_DOUBLE_EQ(number(row, "baseline_bytes"), 124);
  EXPECT_DOUBLE_EQ(number(row, "r1_bytes"), 70.24);
  EXPECT_DOUBLE_EQ(number(row, "m0_bytes"), 72.8);
  EXPECT_TRUE(row.at("paper_leaf_size").is_null());
  row = row_of(table, {"one_leaf", "lbvh"});
  EXPECT_DOUBLE_EQ(number(row, "baseline_bytes"), 108);
  EXPECT_DOUBLE_EQ(number(row, "m1_bytes"), 108);
}

TEST(EvalTables, figure_7_counts_by_depth_and_below) {
  const Table table = figure7_tables({hundred(), one_leaf()}).at(0);
  ASSERT_EQ(table.rows.size(), 3U);
  const Json row = row_of(table, {"hundred", 2});
  EXPECT_EQ(row.at("relative"), 6);
  EXPECT_EQ(row.at("relative_below"), 8);
  EXPECT_EQ(row.at("modulo"), 2);
  EXPECT_EQ(row.at("modulo_below"), 2);
  EXPECT_EQ(row_of(table, {"hundred", 3}).at("modulo"), 0);
}

TEST(EvalChecks, backtracks_with_treelets_that_are_not_the_deeper_iterations_fail) {
  SceneMeasure scene = hundred();
  check_depths(scene);
  EXPECT_EQ(scene.checks, 8U);
  EXPECT_TRUE(scene.failures.empty());
  scene.modulo.backtracks[1] = 3;
  check_depths(scene);
  ASSERT_EQ(scene.failures.size(), 1U);
  EXPECT_EQ(scene.failures[0],
            "hundred: modulo codes: 3 backtracks with treelets of 2 levels, but 2 at depth 2 and below without");
}

TEST(EvalTables, figure_10_takes_the_cloth_apart_and_averages_the_others) {
  SceneMeasure cloth = hundred();
  cloth.name = "proc:cloth";
  cloth.sweep = {{-30, 10, 2, 5}, {std::nullopt, 5, 0, 4}};
  SceneMeasure first = hundred();
  first.sweep = {{-30, 20, 4, 8}, {std::nullopt, 20, 4, 10}};
  SceneMeasure second = one_leaf();
  second.sweep = {{-30, 0, 0, 3}, {std::nullopt, 0, 0, 3}};
  const Table table = figure10_tables({first, cloth, second}).at(0);
  ASSERT_EQ(table.rows.size(), 2U);
  const Json row = row_of(table, {"-30"});
  EXPECT_DOUBLE_EQ(number(row, "cloth_backtracks_1"), 0.1);
  EXPECT_DOUBLE_EQ(number(row, "cloth_backtracks_4"), 0.02);
  EXPECT_DOUBLE_EQ(number(row, "cloth_sah"), 1.25);
  EXPECT_DOUBLE_EQ(number(row, "others_backtracks_1"), 0.1);
  EXPECT_DOUBLE_EQ(number(row, "others_backtracks_4"), 0.02);
  EXPECT_DOUBLE_EQ(number(row, "others_sah"), 1);
  EXPECT_DOUBLE_EQ(number(row_of(table, {"auto"}), "others_sah"), (1.25 + 1) / 2);
  EXPECT_TRUE(row_of(figure10_tables({first}).at(0), {"auto"}).at("cloth_sah").is_null());
  EXPECT_EQ(figure10_tables({first, cloth, second}).at(1).rows.size(), 6U);
}

TEST(EvalTables, table_2_normalizes_each_scene_before_it_averages) {
  SceneMeasure bunny = hundred();
  bunny.name = "bunny";
  bunny.triangles = 69451;
  bunny.runtime = RuntimeRow{"bunny", {2, 3, 4, 1}, {1.5, 1.25, 2, 1}, 1.0};
  SceneMeasure other = hundred();
  other.runtime = RuntimeRow{"hundred", {10, 10, 12, 9}, {1, 1, 1, 1}, 2.0};
  const std::vector<Table> tables = table2_tables({bunny, other});
  ASSERT_EQ(tables.size(), 4U);
  EXPECT_EQ(tables[0].rows.size(), 3U) << "the paper's row under its own bunny only";
  EXPECT_EQ(number(row_of(tables[0], {"bunny", "paper"}), "top_down_ms"), 1.6);
  EXPECT_EQ(number(row_of(tables[0], {"hundred", "measured"}), "modulo_4_ms"), 9);
  const Json top_down = row_of(tables[1], {"+ top-down pass"});
  EXPECT_DOUBLE_EQ(number(top_down, "average"), 1.25);
  EXPECT_DOUBLE_EQ(number(top_down, "min"), 1);
  EXPECT_DOUBLE_EQ(number(top_down, "max"), 1.5);
  EXPECT_EQ(number(top_down, "paper_average"), 1.36);
  EXPECT_EQ(number(row_of(tables[2], {"bunny"}), "relative_over_bound"), 2);
  EXPECT_EQ(tables[3].rows.size(), 16U);
}

TEST(Paper, its_averages_follow_from_its_rows) {
  std::array<double, kRuntimes> sum{};
  double leaf_size = 0;
  for (const PaperScene& scene : paper_scenes()) {
    for (std::size_t i = 0; i < kRuntimes; ++i) sum[i] += scene.milliseconds[i] / scene.milliseconds[0] / 16;
    leaf_size += scene.leaf_size / 16;
  }
  for (std::size_t i = 0; i < kRuntimes; ++i) EXPECT_NEAR(sum[i], kPaperAverageRuntime[i], 0.04);  // printed rounded
  EXPECT_NEAR(leaf_size, 2.1, 0.05);
}

TEST(Paper, only_the_same_mesh_counts_as_the_same_scene) {
  SceneMeasure scene = hundred();
  scene.name = "bunny";
  EXPECT_EQ(paper_counterpart(scene).same, nullptr);
  EXPECT_NE(paper_counterpart(scene).note, "");
  scene.triangles = 69451;
  ASSERT_NE(paper_counterpart(scene).same, nullptr);
  EXPECT_EQ(paper_counterpart(scene).same->leaf_size, 1.1);
  for (const char* name :
       {"armadillo", "folder/Sponza.glb", "dragon", "proc:cloth,sheet=10", "proc:hairball", "fairy"}) {
    scene.name = name;
    EXPECT_EQ(paper_counterpart(scene).same, nullptr) << name;
    EXPECT_NE(paper_counterpart(scene).note, "") << name;
  }
  scene.name = "proc:terrain";
  EXPECT_EQ(paper_counterpart(scene).note, "");
}

TEST(Tables, text_json_and_csv_escape_what_would_break_them) {
  const Table table{"t",
                    "T",
                    {{"name", "name"}, {"x", "x|y", 2}, {"b", "bar", 0, true}},
                    1,
                    {{"a,\"b|c", 0.125, "=="}, {"d", Json(), ""}},
                    {"n"},
                    true};
  EXPECT_EQ(to_csv(table), "t,\"a,\"\"b|c\",x,0.125\n");
  EXPECT_EQ(to_json(table).at("rows"), Json::parse(R"([{"name": "a,\"b|c", "x": 0.125}, {"name": "d", "x": null}])"));
  EXPECT_EQ(to_markdown(table),
            "## T\n\n| name    | x\\|y | bar |\n| :------ | ---: | :-- |\n| a,\"b\\|c | 0.12 | ==  |\n"
            "| d       |    - |     |\n\n- n\n\n");
}

}  // namespace
}  // namespace cbvh::testbench
