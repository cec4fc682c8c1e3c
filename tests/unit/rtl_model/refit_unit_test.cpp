// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "rtl_model/refit/refit_unit.h"

#include <gtest/gtest.h>

#include <functional>

#include "golden/build/lbvh.h"
#include "golden/quantize/scale.h"
#include "golden/scene/load.h"
#include "golden/scene/trouble_scenes.h"
#include "golden/update/refit.h"
#include "golden/update/top_down.h"
#include "rtl_model/compress/lazy_treelet_collector.h"
#include "tests/support/scene_memory.h"
#include "tests/support/stalling_port.h"
#include "vectors/convert.h"

namespace cbvh::rtl {
namespace {

using golden::Code;
using testing::Disturbance;
using testing::StallingPort;

constexpr std::uint64_t kIds = 0, kPrimitives = 2000, kPairs = 20000;

struct Setting {
  Code code = Code::modulo;
  int levels = 4;
  unsigned latency = 8;
  unsigned jitter = 0;
  std::size_t written_lines = 128;
  std::size_t primitive_lines = 64;
  std::size_t outstanding = 16;
};

struct Run {
  bool finished = false;
  RefitReport report;
  std::vector<golden::CompressedPair> pairs;
  std::uint64_t cycles = 0;
  std::uint64_t primitive_reads = 0;
  std::uint64_t node_writes = 0;
  std::uint64_t reads = 0;
  std::uint64_t writes = 0;
};

/// What lies in memory before; a test may spoil it.
struct Scene {
  std::vector<golden::CompressedPair> pairs;
  std::vector<std::uint32_t> ids;
  golden::Mesh moved;
  golden::FloatTree wanted;

  /// The tree of a mesh, and the mesh as it is to be refitted to.
  Scene(const golden::Mesh& before, golden::Mesh after) : moved(std::move(after)) {
    const auto tree = golden::build_lbvh(before);
    const golden::GridRules rules{6, golden::exactness_limit(tree.largest_magnitude), golden::ScaleRule::equation2};
    pairs = golden::compress_top_down(tree, rules, Code::modulo).pairs;
    ids = tree.primitive_ids;
    wanted = golden::refit(tree, moved);
  }
};

template <int N>
golden::GridRules rules_of(const Scene& scene) {
  return {N, golden::exactness_limit(scene.wanted.largest_magnitude), golden::ScaleRule::equation2};
}

template <int N, template <class, int> class Collector = TreeletCollector>
Run refit(const Scene& scene, const Setting& setting, const Disturbance& disturbance = {}) {
  Channel<RefitCommand> commands;
  Channel<RefitReport> reports;
  StallingPort tree(disturbance, 0), ids(disturbance, 1), primitives(disturbance, 2), nodes(disturbance, 3);
  RefitConfig config;
  config.addresses = {LineAddress(kPairs), LineAddress(kIds), LineAddress(kPrimitives)};
  config.treelet_levels = setting.levels;
  config.outstanding = setting.outstanding;
  config.gatherer.held_lines = setting.primitive_lines;
  config.gatherer.outstanding = setting.outstanding;
  config.written_lines = setting.written_lines;
  RefitUnit<MachineBits, N, Collector> unit(commands, reports,
                                            {tree.near(), ids.near(), primitives.near(), nodes.near()}, config);
  IdealLineMemory memory({tree.far(), ids.far(), primitives.far(), nodes.far()}, 30000, setting.latency, setting.jitter,
                         disturbance.seed);
  testing::poke_pairs(memory.store, kPairs, scene.pairs);
  testing::poke_ids(memory.store, kIds, scene.ids);
  testing::poke_primitives(memory.store, kPrimitives, scene.moved);
  Clock clock(unit, tree, ids, primitives, nodes, memory, commands, reports);
  Run run;
  commands.push({ItemCount(scene.pairs.size()), ItemCount(scene.ids.size()),
                 vectors::scene_registers(rules_of<N>(scene), setting.code)});
  run.finished =
      testing::run_until(clock, disturbance, 20000 + 2000 * scene.ids.size(), [&] { return reports.can_pop(); });
  if (!run.finished) return run;
  run.report = reports.front();
  run.cycles = clock.cycle();
  run.pairs = testing::peek_pairs(memory.store, kPairs, scene.pairs.size());
  run.primitive_reads = unit.gatherer().lines_read;
  run.node_writes = unit.writer().lines_written;
  run.reads = memory.reads;
  run.writes = memory.writes;
  return run;
}

template <int N, template <class, int> class Collector = TreeletCollector>
void expect_top_down(const Scene& scene, const Setting& setting, const Disturbance& disturbance = {}) {
  const auto wanted = golden::compress_top_down(scene.wanted, rules_of<N>(scene), setting.code);
  const auto run = refit<N, Collector>(scene, setting, disturbance);
  ASSERT_TRUE(run.finished);
  EXPECT_EQ(run.report.walk, WalkReport());
  EXPECT_EQ(run.report.tree.status, StatusBits());
  EXPECT_EQ(run.report.tree.last_index.value() + 1, scene.pairs.size());
  EXPECT_EQ(run.report.tree.root, vectors::context(wanted.root));
  EXPECT_TRUE(run.pairs == wanted.pairs);
}

golden::Mesh turned(golden::Mesh mesh) {
  for (auto& p : mesh.positions) p = glm::vec3(p.z, -p.x, p.y * 0.5F);
  return mesh;
}
Scene exploding(const std::string& time, const std::string& triangles) {
  const std::string scene = "proc:explode,fragments=16,triangles=" + triangles;
  return {golden::load_scene(scene), golden::load_scene(scene + ",time=" + time)};
}
Scene turned_scene(const std::string& name) {
  const auto mesh = golden::load_scene(name);
  return {mesh, turned(mesh)};
}

TEST(RefitUnit, refitted_tree_equals_the_top_down_tree_of_the_moved_mesh) {
  std::size_t trees = 0;
  for (const char* time : {"0", "0.1", "1", "30"}) {
    const auto scene = exploding(time, "3000");
    for (const auto code : {Code::modulo, Code::relative}) {
      for (const int levels : {1, 2, 4}) {
        expect_top_down<6>(scene, {code, levels});
        expect_top_down<6, LazyTreeletCollector>(scene, {code, levels});
        expect_top_down<4>(scene, {code, levels});
        trees += 3;
        ASSERT_FALSE(::testing::Test::HasFailure());
      }
    }
  }
  for (const char* name :
       {"proc:cloth,sheet=30,height=20", "proc:terrain,triangles=2000", "proc:hairball,triangles=2000"}) {
    expect_top_down<6>(turned_scene(name), {});
    ++trees;
  }
  EXPECT_EQ(trees, 75u);
}

TEST(RefitUnit, trees_of_troublesome_scenes_are_refitted_in_place) {
  std::size_t trees = 0;
  for (std::uint64_t id = 0; id < 240; ++id) {
    const auto mesh = golden::trouble_scene(golden::kTroubles[id % golden::kTroubles.size()], id, 60);
    const Scene scene(mesh, turned(mesh));
    if (scene.pairs.empty()) continue;  // one leaf
    expect_top_down<6>(scene, {id % 2 == 0 ? Code::modulo : Code::relative, 1 + static_cast<int>(id % 5)});
    ASSERT_FALSE(::testing::Test::HasFailure()) << mesh.name;
    ++trees;
  }
  EXPECT_GT(trees, 150u);
}

TEST(RefitUnit, in_place_is_free_of_hazards_under_stalls_jitter_and_any_order_of_evaluation) {
  const auto scene = exploding("0.5", "800");
  for (const auto& disturbance : testing::stall_matrix()) {
    for (const unsigned jitter : {0u, 3u, 60u}) {
      for (const int levels : {1, 3}) {
        Setting setting{Code::relative, levels, 1 + jitter * 2, jitter};
        setting.written_lines = levels == 1 ? 1 : 4;
        setting.primitive_lines = jitter == 3 ? 1 : 16;
        setting.outstanding = jitter == 3 ? 1 : 8;
        expect_top_down<6>(scene, setting, disturbance);
        ASSERT_FALSE(::testing::Test::HasFailure());
      }
    }
  }
}

TEST(RefitUnit, traffic_is_that_of_the_arrays_and_the_gatherer_and_a_pair_takes_two_clocks) {
  const auto scene = exploding("0.2", "20000");
  const auto run = refit<6>(scene, {});
  ASSERT_TRUE(run.finished);
  const auto lines = [](std::size_t items, std::size_t per_line) { return (items + per_line - 1) / per_line; };
  const auto repairs = run.report.tree.repairs.value();
  ASSERT_LE(repairs, 4u);
  EXPECT_LE(run.reads, lines(scene.pairs.size(), 4) + lines(scene.ids.size(), 16) + run.primitive_reads + repairs);
  EXPECT_LE(static_cast<double>(run.primitive_reads), 1.2 * static_cast<double>(lines(scene.ids.size() * 10, 16)));
  EXPECT_EQ(run.writes, run.node_writes);
  EXPECT_LE(static_cast<double>(run.node_writes), 1.05 * static_cast<double>(lines(scene.pairs.size(), 4)));
  RecordProperty("primitive_lines_read", std::to_string(run.primitive_reads));
  RecordProperty("primitive_lines", std::to_string(lines(scene.ids.size() * 10, 16)));
  RecordProperty("cycles", std::to_string(run.cycles));
  RecordProperty("pairs", std::to_string(scene.pairs.size()));
  EXPECT_LE(static_cast<double>(run.cycles), 2.0 * static_cast<double>(scene.pairs.size()) + 500);
}

// Trees that do not belong to the primitives.

WalkReport fault(RefitFault reason, std::uint64_t place) {
  return {RefitFaultBits(static_cast<std::uint64_t>(reason)), Pointer(place)};
}

void expect_fault(const Scene& scene, const WalkReport& wanted) {
  for (const auto& disturbance : testing::stall_matrix()) {
    const auto run = refit<6>(scene, {Code::modulo, 2, 5, 7}, disturbance);
    ASSERT_TRUE(run.finished);
    EXPECT_EQ(run.report.walk, wanted);
    EXPECT_NE(run.report.tree.status, StatusBits());
  }
}

TEST(RefitUnit, refuses_a_tree_that_does_not_belong_to_the_primitives_and_says_where) {
  const Scene valid = exploding("0.5", "200");
  const auto spoiled = [&](const std::function<void(Scene&)>& spoil) {
    Scene scene = valid;
    spoil(scene);
    return scene;
  };
  const auto inner = [&](std::size_t from, std::size_t child) {
    while (valid.pairs[from].child[child].leaf) ++from;
    return from;
  };
  const auto leaf = [&](std::size_t from, std::size_t child) {
    while (!valid.pairs[from].child[child].leaf) ++from;
    return from;
  };
  for (const std::size_t child : {0u, 1u}) {
    const auto i = inner(20, child);
    expect_fault(spoiled([&](Scene& s) { --s.pairs[i].child[child].pointer; }), fault(RefitFault::not_post_order, i));
    expect_fault(spoiled([&](Scene& s) { s.pairs[i].child[child].pointer = static_cast<std::uint32_t>(i); }),
                 fault(RefitFault::not_post_order, i));
    const auto l = leaf(30, child);
    expect_fault(spoiled([&](Scene& s) { --s.pairs[l].child[child].pointer; }), fault(RefitFault::not_post_order, l));
  }
  const auto right_leaf = leaf(30, 1);
  expect_fault(spoiled([&](Scene& s) { s.pairs[right_leaf].child[1].pointer = 1u << 26; }),
               fault(RefitFault::too_deep, right_leaf));
  expect_fault(spoiled([&](Scene& s) {
                 s.pairs.back().child[0].pointer = 0;  // the left half is not in the tree
                 s.pairs.back().child[0].leaf = true;
               }),
               fault(RefitFault::not_post_order, valid.pairs.size() - 1));
  expect_fault(spoiled([&](Scene& s) { s.pairs.pop_back(); }), fault(RefitFault::leftovers, valid.pairs.size() - 2));
  expect_fault(spoiled([&](Scene& s) { s.ids.push_back(0); }), fault(RefitFault::leftovers, valid.pairs.size() - 1));
  expect_fault(spoiled([&](Scene& s) { s.ids[40] = 200 | (s.ids[40] & golden::kLastOfLeaf); }),
               fault(RefitFault::id_out_of_range, 40));
  expect_fault(spoiled([&](Scene& s) { s.ids.back() &= ~golden::kLastOfLeaf; }),
               fault(RefitFault::ids_missing, valid.ids.size() - 1));
  const auto vertex = valid.moved.triangles[valid.ids[10] & ~golden::kLastOfLeaf].y;
  expect_fault(spoiled([&](Scene& s) { s.moved.positions[vertex].x = std::numeric_limits<float>::infinity(); }),
               fault(RefitFault::primitive_not_finite, 10));
}

}  // namespace
}  // namespace cbvh::rtl
