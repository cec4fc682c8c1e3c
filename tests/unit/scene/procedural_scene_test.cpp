// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "scene_files.h"

#include <fmt/format.h>

#include <set>

namespace cbvh::golden {
namespace {

std::size_t triangles(const std::string& scene) { return load_scene("proc:" + scene).triangles.size(); }

std::uint64_t fnv1a(const Mesh& mesh) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const char c : bytes_of(mesh.positions) + bytes_of(mesh.triangles))
    hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  return hash;
}

TEST(ProceduralScene, cloth_is_the_scene_of_the_reference_results) {
  const Mesh cloth = load_scene("proc:cloth");
  EXPECT_EQ(cloth.name, "proc:cloth");
  ASSERT_EQ(cloth.triangles.size(), 65000u);
  ASSERT_EQ(cloth.positions.size(), 151u * 151 + 101 * 101);
  EXPECT_EQ(cloth.positions[0], glm::vec3(-1.0f, -1.0f, -0.4f));
  EXPECT_EQ(cloth.positions[1], glm::vec3(-1.0f, -1.0f + 2.0f / 150.0f, -0.4f));  // j is the inner loop
  EXPECT_EQ(cloth.positions[151 * 151 - 1], glm::vec3(1.0f, 1.0f, -0.4f));
  EXPECT_EQ(cloth.positions[151 * 151],
            glm::vec3(-0.8f, -0.8f, 0.1f + 0.25f * (1.0f - 0.8f * 0.8f) * (1.0f - 0.8f * 0.8f)));
  EXPECT_EQ(cloth.triangles[0], glm::uvec3(0, 151, 152));
  EXPECT_EQ(cloth.triangles[1], glm::uvec3(0, 152, 1));
  EXPECT_EQ(cloth.triangles[45000], glm::uvec3(22801, 22902, 22903));
}

TEST(ProceduralScene, every_scene_is_the_same_for_every_compiler) {
  const std::pair<const char*, std::uint64_t> wanted[] = {
      {"proc:cloth", 0xfd0e4a2cd5ac28a7},    {"proc:soup", 0xa4d2c3d6efc28304},
      {"proc:spheres", 0x56e18fb2aaf9be8d},  {"proc:terrain", 0x0da64a0234068345},
      {"proc:hairball", 0xd894ca18e0f09387}, {"proc:city", 0x625d41cc302d9f4f},
      {"proc:explode", 0xfe2247f90e935f95},  {"proc:explode,time=0.5", 0xa8ebd80d3a621381},
      {"proc:morph", 0x9c9919d6c31a1af5},    {"proc:morph,time=0.4", 0xbdc9e744c3365c89}};
  std::set<std::string> seen;
  for (const auto& [scene, hash] : wanted) {
    EXPECT_EQ(fnv1a(load_scene(scene)), hash) << scene;
    seen.insert(std::string(scene).substr(5, std::string(scene).find(',') - 5));
  }
  for (const std::string& name : procedural_scene_names()) EXPECT_EQ(seen.count(name), 1u) << name;
}

TEST(ProceduralScene, the_number_of_triangles_is_the_documented_one) {
  EXPECT_EQ(triangles("cloth,sheet=1,height=3"), 2u + 18);
  for (const unsigned n : {100u, 1000u, 54321u}) {
    EXPECT_EQ(triangles(fmt::format("soup,triangles={}", n)), n);
    EXPECT_EQ(triangles(fmt::format("city,triangles={}", n)), 2 + 12 * ((n - 2) / 12));
    EXPECT_EQ(triangles(fmt::format("hairball,triangles={},segments=7", n)), 14 * (n / 14));
    unsigned side = 1;
    while (2 * (side + 1) * (side + 1) <= n) ++side;
    EXPECT_EQ(triangles(fmt::format("terrain,triangles={}", n)), 2 * side * side);
    unsigned k = 1;
    while (8 * (k + 1) * (k + 1) <= n) ++k;
    EXPECT_EQ(triangles(fmt::format("explode,triangles={}", n)), 8 * k * k);
    EXPECT_EQ(triangles(fmt::format("spheres,spheres=1,triangles={}", n)), 8 * k * k);
  }
  EXPECT_EQ(triangles("spheres,spheres=1000,triangles=8"), 8000u);
  EXPECT_EQ(triangles("soup,triangles=1"), 1u);
}

TEST(ProceduralScene, four_million_triangles_are_possible) {
  EXPECT_EQ(triangles("soup,triangles=4194304"), 4194304u);
  EXPECT_EQ(triangles("cloth,sheet=1024,height=1024"), 4194304u);
}

TEST(ProceduralScene, the_seed_changes_every_scene_that_has_one) {
  for (const std::string& name : procedural_scene_names()) {
    if (name == "cloth") continue;
    const std::string scene =
        "proc:" + name + ",triangles=1000" + (name == "explode" || name == "morph" ? ",time=1" : "");
    EXPECT_EQ(fnv1a(load_scene(scene)), fnv1a(load_scene(scene + ",seed=1"))) << name;
    EXPECT_NE(fnv1a(load_scene(scene)), fnv1a(load_scene(scene + ",seed=2"))) << name;
  }
}

TEST(ProceduralScene, explode_starts_whole_and_keeps_its_triangles_over_time) {
  const Mesh start = load_scene("proc:explode,triangles=800");
  const Mesh later = load_scene("proc:explode,triangles=800,time=2");
  EXPECT_EQ(start.triangles, later.triangles);
  EXPECT_NE(start.positions, later.positions);
  float farthest = 0.0f;
  for (std::size_t i = 0; i < start.positions.size(); ++i) {
    const glm::vec3& p = start.positions[i];
    EXPECT_FLOAT_EQ(p.x * p.x + p.y * p.y + p.z * p.z, 1.0f);
    const glm::vec3& q = later.positions[i];
    farthest = std::max(farthest, q.x * q.x + q.y * q.y + q.z * q.z);
  }
  EXPECT_GT(farthest, 4.0f);
}

TEST(ProceduralScene, morph_goes_through_its_four_shapes_and_keeps_its_triangles) {
  const Mesh start = load_scene("proc:morph,triangles=800");
  const Mesh sheet = load_scene("proc:morph,triangles=800,time=0.33333334");
  const Mesh end = load_scene("proc:morph,triangles=800,time=1");
  EXPECT_EQ(start.triangles, sheet.triangles);
  EXPECT_EQ(start.triangles, end.triangles);
  for (std::size_t i = 0; i < start.triangles.size(); ++i) {
    const auto middle = [i](const Mesh& mesh) {
      return (mesh.positions[3 * i] + mesh.positions[3 * i + 1] + mesh.positions[3 * i + 2]) / 3.0f;
    };
    const auto distance = [](const glm::vec3& p) { return std::sqrt(p.x * p.x + p.y * p.y + p.z * p.z); };
    EXPECT_NEAR(distance(middle(start)), 1, 0.03);
    EXPECT_NEAR(middle(sheet).y, 0, 1e-5);
    EXPECT_NEAR(distance(middle(end)), 0.5, 0.02);
  }
  // Without mixing every triangle ends where it was, nearer to the centre.
  const Mesh still = load_scene("proc:morph,triangles=800,time=1,mix=0");
  const glm::vec3 moved = (still.positions[0] + still.positions[1] + still.positions[2]) * 2.0f;
  const glm::vec3 before = start.positions[0] + start.positions[1] + start.positions[2];
  for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(moved[axis], before[axis], 1e-5);
}

TEST(ProceduralScene, rotated_is_45_degrees_around_each_axis_with_the_same_bits_for_every_compiler) {
  const Mesh before = load_scene("proc:city,triangles=1000");
  const Mesh after = load_scene("rotated:proc:city,triangles=1000");
  EXPECT_EQ(after.name, "rotated:proc:city,triangles=1000");
  EXPECT_EQ(after.triangles, before.triangles);
  EXPECT_EQ(fnv1a(after), 0x24d9ee86acc45528);
  for (std::size_t i = 0; i < before.positions.size(); ++i) {
    const glm::dvec3 p(before.positions[i]);
    const glm::dvec3 q(after.positions[i]);
    EXPECT_NEAR(q.x * q.x + q.y * q.y + q.z * q.z, p.x * p.x + p.y * p.y + p.z * p.z, 0.1);
    const double half = std::sqrt(0.5);  // around x, then y, then z
    const double y = (p.y - p.z) * half;
    const double z = (p.y + p.z) * half;
    const double x = (p.x + z) * half;
    EXPECT_NEAR(q.z, (z - p.x) * half, 1e-4);
    EXPECT_NEAR(q.x, (x - y) * half, 1e-4);
    EXPECT_NEAR(q.y, (x + y) * half, 1e-4);
  }
  EXPECT_EQ(error_of("rotated:proc:city,size=1").substr(0, 15), "proc:city,size=");
}

TEST(ProceduralScene, city_is_made_of_axis_parallel_boxes) {
  const Mesh city = load_scene("proc:city,triangles=1000");
  for (const glm::uvec3& t : city.triangles) {
    int flat_axes = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const float a = city.positions[t.x][axis];
      flat_axes += a == city.positions[t.y][axis] && a == city.positions[t.z][axis];
    }
    EXPECT_EQ(flat_axes, 1);
  }
}

TEST(ProceduralScene, bad_descriptions_are_refused_with_what_is_known) {
  EXPECT_EQ(error_of("proc:clothe"),
            "proc:clothe: procedural scene: found 'clothe', wanted one of cloth, soup, spheres, terrain, hairball, "
            "city, explode, morph");
  EXPECT_EQ(
      error_of("proc:"),
      "proc:: procedural scene: found '', wanted one of cloth, soup, spheres, terrain, hairball, city, explode, morph");
  EXPECT_EQ(error_of("proc:cloth,a=1"), "proc:cloth,a=1: option: found 'a', wanted one of sheet, height");
  EXPECT_EQ(error_of("proc:cloth,sheet"), "proc:cloth,sheet: option: found 'sheet', wanted key=value");
  EXPECT_EQ(error_of("proc:cloth,"), "proc:cloth,: option: found '', wanted key=value");
  EXPECT_EQ(error_of("proc:cloth,sheet=2,sheet=2"), "proc:cloth,sheet=2,sheet=2: option sheet: given twice");
  for (const char* bad : {"0", "1025", "", "x", "2.5", "-1", "1e3", "99999999999999999999", " 2", "2 "}) {
    const std::string scene = fmt::format("proc:cloth,sheet={}", bad);
    EXPECT_EQ(error_of(scene),
              fmt::format("{}: option sheet: found '{}', wanted an integer from 1 to 1024", scene, bad));
  }
  for (const char* bad : {"nan", "inf", "-0.1", "1001", ""}) {
    const std::string scene = fmt::format("proc:explode,time={}", bad);
    EXPECT_EQ(error_of(scene), fmt::format("{}: option time: found '{}', wanted a number from 0 to 1000", scene, bad));
  }
  EXPECT_EQ(error_of("proc:soup,triangles=4194305"),
            "proc:soup,triangles=4194305: option triangles: found '4194305', wanted an integer from 1 to 4194304");
}

TEST(ProceduralScene, the_help_names_every_scene_and_option) {
  const std::string help = procedural_scene_help();
  for (const std::string& name : procedural_scene_names())
    EXPECT_NE(help.find("proc:" + name + " "), help.npos) << name;
  for (const char* option : {"sheet=150", "height=100", "triangles=", "seed=1", "time=0", "fragments=64"})
    EXPECT_NE(help.find(option), help.npos) << option;
}

}  // namespace
}  // namespace cbvh::golden
