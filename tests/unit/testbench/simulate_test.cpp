// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/sim/simulate.h"

#include <gtest/gtest.h>

#include "golden/scene/load.h"

namespace cbvh::testbench {
namespace {

SimRequest request_of(const std::string& config, const std::vector<std::string>& values = {}) {
  SimRequest request;
  request.config = load_sim_config(config);
  for (const std::string& value : values) set_sim_parameter(request.config, value, "test");
  check_sim_config(request.config);
  request.machine.watchdog_cycles = request.config.watchdog_cycles;
  return request;
}

const golden::Mesh& cloth() {
  static const golden::Mesh mesh = golden::load_scene("proc:cloth");
  return mesh;
}
golden::Mesh scene(const std::string& text) { return golden::load_scene(text); }

std::string error_of(const std::function<void()>& work) {
  try {
    work();
  } catch (const golden::InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(Simulate, leaves_the_goldens_tree_in_memory_in_every_configuration) {
  for (const std::string& name : sim_config_names()) {
    const SimResult result = simulate_lbvh(cloth(), request_of(name));
    EXPECT_TRUE(result.pass()) << name << ": " << to_text(result);
    EXPECT_EQ(result.pairs, 36721U);
    EXPECT_EQ(result.digest, name == "float" ? "" : "8bd6f10416322ba7") << name << ": the digest of DESIGN 3.2";
    EXPECT_EQ(result.repairs, name == "streaming-relative" ? 19275U : 0U) << name;
  }
}

TEST(Simulate, result_is_the_same_bits_with_stalls_jitter_and_shuffled_order) {
  const golden::Mesh mesh = scene("proc:soup,triangles=1500");
  for (const std::string& name : sim_config_names()) {
    const std::uint64_t calm = simulate_lbvh(mesh, request_of(name)).cycles;
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      SimRequest request = request_of(name, {"dram.jitter=90", "dram.seed=" + std::to_string(seed)});
      request.machine.stalls = seed;
      if (seed == 2) request.machine.shuffle = seed;
      const SimResult result = simulate_lbvh(mesh, request);
      EXPECT_TRUE(result.pass()) << name << ": " << to_text(result);
      EXPECT_GT(result.cycles, calm) << "the stalls must have been felt";
    }
  }
}

TEST(Simulate, evaluation_order_changes_neither_bits_nor_cycles) {
  const golden::Mesh mesh = scene("proc:hairball,triangles=2000");
  for (const std::string& name : sim_config_names()) {
    SimRequest request = request_of(name);
    const SimResult given = simulate_lbvh(mesh, request);
    request.machine.shuffle = 7;
    const SimResult shuffled = simulate_lbvh(mesh, request);
    EXPECT_TRUE(shuffled.pass());
    EXPECT_EQ(given.cycles, shuffled.cycles) << name;
  }
}

TEST(Simulate, both_collectors_and_every_treelet_depth_leave_the_same_tree) {
  const golden::Mesh mesh = scene("proc:terrain,triangles=3000");
  for (const char* collector : {"collector=full", "collector=lazy"}) {
    for (const char* code : {"code=modulo", "code=relative"}) {
      for (const char* treelet : {"treelet=1", "treelet=2", "treelet=3", "treelet=5"}) {
        const SimResult result = simulate_lbvh(mesh, request_of("streaming-modulo", {collector, code, treelet}));
        EXPECT_TRUE(result.pass()) << collector << code << treelet << to_text(result);
      }
    }
  }
}

TEST(Simulate, a_small_scratchpad_takes_more_passes_and_leaves_the_same_tree) {
  const golden::Mesh mesh = scene("proc:soup,triangles=5000");
  std::uint64_t passes = 0;
  for (const char* bytes :
       {"scratchpad_bytes=262144", "scratchpad_bytes=8192", "scratchpad_bytes=1024", "scratchpad_bytes=512"}) {
    const SimResult result = simulate_lbvh(mesh, request_of("streaming-modulo", {bytes}));
    EXPECT_TRUE(result.pass()) << bytes << to_text(result);
    EXPECT_GE(result.merge_passes, passes);
    passes = result.merge_passes;
  }
  EXPECT_GE(passes, 3U);
}

TEST(Simulate, handles_one_triangle_one_leaf_and_few_triangles) {
  for (const char* name :
       {"proc:soup,triangles=1", "proc:soup,triangles=2", "proc:soup,triangles=3", "proc:soup,triangles=17"}) {
    for (const std::string& config : sim_config_names()) {
      const SimResult result = simulate_lbvh(scene(name), request_of(config));
      EXPECT_TRUE(result.pass()) << name << config << to_text(result);
    }
  }
}

TEST(Simulate, counted_traffic_is_the_model_and_what_whole_lines_cost) {
  const SimResult result = simulate_lbvh(cloth(), request_of("float"));
  std::map<std::string, std::uint64_t> counted;
  for (const TrafficRow& row : result.traffic) {
    EXPECT_TRUE(row.exact()) << row.purpose;
    counted[row.purpose] = row.counted_bytes();
  }
  EXPECT_EQ(counted["primitives read"], 65000U * 40);  // 40,625 lines
  EXPECT_EQ(counted["primitive IDs written"], (65000U * 4 + 63) / 64 * 64);
  EXPECT_EQ(counted["float pairs written"], 36721U * 64);
  EXPECT_GE(counted["sorted boxes written"], 65000U * 32);
  EXPECT_LE(counted["sorted boxes written"], 65000U * 32 + 32 * result.runs);
  EXPECT_EQ(counted["sorted boxes read"], counted["sorted boxes written"]);
}

TEST(Simulate, a_lost_answer_is_a_deadlock_that_names_who_waits) {
  const golden::Mesh mesh = scene("proc:soup,triangles=3000");
  const auto text = [&](const char* lost) {
    return error_of([&] { simulate_lbvh(mesh, request_of("streaming-modulo", {lost, "watchdog_cycles=10000"})); });
  };
  const std::string early = text("dram.lose_answer=100");
  EXPECT_NE(early.find("deadlock in cycle"), std::string::npos) << early;
  EXPECT_NE(early.find("box_builder waits for primitives from primitive_reader"), std::string::npos) << early;
  const std::string late = text("dram.lose_answer=2500");
  EXPECT_NE(late.find("hierarchy_emitter waits for sorted from run_merger"), std::string::npos) << late;
  EXPECT_EQ(late.find("box_builder waits"), std::string::npos) << "its stream has ended: " << late;
}

TEST(Simulate, refuses_what_cannot_be_simulated_and_says_why) {
  const golden::Mesh mesh = scene("proc:soup,triangles=100");
  const auto text = [&](const char* value) {
    return error_of([&] { simulate_lbvh(mesh, request_of("streaming-modulo", {value})); });
  };
  EXPECT_EQ(text("max_triangles=99"), mesh.name + ": 100 triangles, max_triangles is 99");
  EXPECT_NE(text("treelet=0").find("treelet: found 0, want 1..8"), std::string::npos);
  EXPECT_NE(text("dram.channels=0").find("channels: 0, want a power of two"), std::string::npos);
  EXPECT_NE(text("scratchpad_bytes=256").find("scratchpad_bytes: found 256, want"), std::string::npos);
  EXPECT_NE(text("min_scale=-60").find("exactness limit"), std::string::npos);
  EXPECT_NE(text("no_such=1").find("unknown 'no_such'"), std::string::npos);
  EXPECT_NE(text("treelet=four").find("found 'four', want an integer"), std::string::npos);
  EXPECT_NE(text("memory=disk").find("found 'disk', want dram or ideal"), std::string::npos);
  EXPECT_NE(error_of([&] {
              simulate_lbvh(scene("proc:soup,triangles=20000"), request_of("float", {"dram.capacity_bytes=1048576"}));
            }).find("dram.capacity_bytes: found 1048576, want"),
            std::string::npos);
  EXPECT_NE(error_of([] { load_sim_config("fast"); }).find("unknown 'fast'"), std::string::npos);
}

TEST(Simulate, ideal_memory_is_never_slower_and_gives_the_same_tree) {
  const golden::Mesh mesh = scene("proc:city,triangles=4000");
  const SimResult dram = simulate_lbvh(mesh, request_of("streaming-modulo"));
  const SimResult ideal = simulate_lbvh(mesh, request_of("streaming-modulo", {"memory=ideal"}));
  EXPECT_TRUE(dram.pass());
  EXPECT_TRUE(ideal.pass()) << to_text(ideal);
  EXPECT_EQ(ideal.digest, dram.digest);
  EXPECT_LE(ideal.cycles, dram.cycles);
}

}  // namespace
}  // namespace cbvh::testbench
