// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/scene/two_level/two_level_scenes.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <set>

#include "golden/input_error.h"
#include "golden/scene/load.h"

namespace cbvh::golden {
namespace {

std::string message_of(const std::string& spec) {
  try {
    load_two_level_scene(spec);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

using Corners = std::array<std::array<float, 3>, 3>;
Corners corners(const Mesh& mesh, const glm::uvec3& triangle) {
  Corners result{};
  for (glm::length_t corner = 0; corner < 3; ++corner) {
    const glm::vec3& p = mesh.positions[triangle[corner]];
    result[static_cast<std::size_t>(corner)] = {p.x, p.y, p.z};
  }
  return result;
}

TEST(TwoLevelScenes, bouncing_instances_are_rigid_up_to_scale_and_stay_in_the_cube) {
  int checks = 0;
  for (const char* time : {"0", "0.25", "1", "7.5", "300"}) {
    const TwoLevelScene scene =
        load_two_level_scene(std::string("bounce,count=64,size=0.125,time=") + time + ":proc:soup,triangles=50");
    ASSERT_EQ(scene.instances.size(), 64U);
    const Mesh& mesh = scene.objects[0];
    glm::vec3 lower = mesh.positions[0];
    glm::vec3 upper = lower;
    for (const glm::vec3& p : mesh.positions) {
      for (glm::length_t axis = 0; axis < 3; ++axis) {
        lower[axis] = std::min(lower[axis], p[axis]);
        upper[axis] = std::max(upper[axis], p[axis]);
      }
    }
    const float widest = std::max({upper.x - lower.x, upper.y - lower.y, upper.z - lower.z});
    const double scale = 0.125 / static_cast<double>(widest / 2);
    for (const Instance& instance : scene.instances) {
      for (glm::length_t a = 0; a < 3; ++a) {
        for (glm::length_t b = 0; b < 3; ++b) {
          double dot = 0;
          for (glm::length_t row = 0; row < 3; ++row)
            dot += static_cast<double>(instance.to_world[a][row]) * static_cast<double>(instance.to_world[b][row]);
          ASSERT_NEAR(dot, a == b ? scale * scale : 0.0, scale * scale * 1e-5);
        }
      }
      const glm::vec3 centre = world_point((lower + upper) * 0.5F, instance.to_world);
      for (glm::length_t axis = 0; axis < 3; ++axis) ASSERT_LE(std::abs(centre[axis]), 1.0001F);
      ++checks;
    }
  }
  EXPECT_EQ(checks, 5 * 64);
}

TEST(TwoLevelScenes, bouncing_instances_move_and_turn_without_jumps) {
  const auto at = [](double time) {
    return load_two_level_scene(fmt::format("bounce,count=50,size=0.5,time={}:proc:soup,triangles=10", time));
  };
  TwoLevelScene before = at(0);
  double travelled = 0;
  for (int step = 1; step <= 400; ++step) {
    const TwoLevelScene now = at(step * 0.02);
    for (std::size_t i = 0; i < now.instances.size(); ++i) {
      for (glm::length_t column = 0; column < 4; ++column) {
        for (glm::length_t row = 0; row < 3; ++row) {
          const double moved = std::abs(static_cast<double>(now.instances[i].to_world[column][row]) -
                                        static_cast<double>(before.instances[i].to_world[column][row]));
          ASSERT_LT(moved, 0.08) << step;
          travelled += moved;
        }
      }
    }
    before = now;
  }
  EXPECT_GT(travelled, 50 * 8.0);
}

TEST(TwoLevelScenes, at_twice_the_speed_instances_are_where_they_are_at_twice_the_time) {
  const TwoLevelScene faster = load_two_level_scene("bounce,count=50,time=0.75,speed=6:proc:soup,triangles=10");
  const TwoLevelScene later = load_two_level_scene("bounce,count=50,time=4.5:proc:soup,triangles=10");
  for (std::size_t i = 0; i < later.instances.size(); ++i)
    EXPECT_EQ(faster.instances[i].to_world, later.instances[i].to_world) << i;
}

TEST(TwoLevelScenes, dealt_objects_have_every_triangle_once_in_turns_of_a_chunk) {
  const Mesh mesh = load_scene("proc:terrain,triangles=1000");
  for (const std::size_t objects : {1U, 3U, 16U, 5000U}) {
    for (const std::size_t chunk : {1U, 7U, 100U, 100000U}) {
      const TwoLevelScene scene =
          load_two_level_scene(fmt::format("deal,objects={},chunk={}:proc:terrain,triangles=1000", objects, chunk));
      std::vector<std::size_t> next(scene.objects.size());
      std::size_t vertices = 0;
      for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const std::size_t object = t / chunk % objects;
        ASSERT_LT(object, scene.objects.size());
        const Mesh& dealt = scene.objects[object];
        ASSERT_LT(next[object], dealt.triangles.size());
        ASSERT_EQ(corners(dealt, dealt.triangles[next[object]++]), corners(mesh, mesh.triangles[t]));
      }
      for (std::size_t i = 0; i < next.size(); ++i) {
        ASSERT_EQ(next[i], scene.objects[i].triangles.size());
        ASSERT_GT(next[i], 0U);
        ASSERT_EQ(scene.instances[i].object, i);
        ASSERT_TRUE(is_identity(scene.instances[i].to_world));
        std::set<std::uint32_t> used;
        for (const glm::uvec3& t : scene.objects[i].triangles) used.insert({t.x, t.y, t.z});
        ASSERT_EQ(used.size(), scene.objects[i].positions.size()) << "each vertex that is used, once";
        vertices += used.size();
      }
      ASSERT_GE(vertices, mesh.positions.size());
    }
  }
}

TEST(TwoLevelScenes, a_description_that_is_none_is_refused_with_what_was_wanted) {
  EXPECT_NE(message_of("bounce").find("wanted KIND:SCENE"), std::string::npos);
  EXPECT_NE(message_of("proc:cloth").find("two-level scene: found 'proc', wanted one of bounce, deal"),
            std::string::npos)
      << message_of("proc:cloth");
  EXPECT_NE(message_of("bounce,count=0:proc:cloth").find("option count"), std::string::npos);
  EXPECT_NE(message_of("bounce:proc:none").find("none"), std::string::npos);
  EXPECT_NE(message_of("deal:no_such.glb").find("no_such.glb"), std::string::npos);
  EXPECT_NE(two_level_help().find("bounce:SCENE"), std::string::npos);
}

}  // namespace
}  // namespace cbvh::golden
