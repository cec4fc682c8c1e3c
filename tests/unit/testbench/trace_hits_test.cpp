// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "golden/build/lbvh.h"
#include "golden/input_error.h"
#include "golden/scene/load.h"
#include "testbench/trace/hits/compare_hits.h"
#include "testbench/trace/hits/one_ray.h"
#include "testbench/unavailable.h"

namespace cbvh::testbench {
namespace {

using golden::Hit;

/// Two triangles that share the edge x = y in the plane z = 1, one behind them at 2, one on the first at 1 with other
/// vertices, and one far aside.
golden::Mesh scene() {
  return {"test",
          {{0, 0, 1},
           {1, 1, 1},
           {1, 0, 1},
           {0, 1, 1},
           {-4, -4, 2},
           {8, -4, 2},
           {-4, 8, 2},
           {0.5F, 0.125F, 1},
           {0.875F, 0.125F, 1},
           {0.875F, 0.5F, 1},
           {50, 50, 1},
           {51, 50, 1},
           {50, 51, 1}},
          {{0, 1, 2}, {0, 1, 3}, {4, 5, 6}, {7, 8, 9}, {10, 11, 12}}};
}

HitRelation relation(const golden::Ray& ray, const Hit& ours, const EmbreeHit& embree) {
  return compare_hit(scene(), ray, ours, embree);
}

const golden::Ray kAtEdge{{0.25F, 0.25F, 0}, {0, 0, 1}};
const golden::Ray kAtFirst{{0.75F, 0.25F, 0}, {0, 0, 1}};
const golden::Ray kAside{{50.25F, 50.25F, 0}, {0, 0, 1}};

TEST(CompareHit, the_same_triangle_is_the_same_and_two_at_one_distance_are_no_miss) {
  EXPECT_EQ(relation(kAtFirst, {0, 1}, {0, 1}), HitRelation::same);
  EXPECT_EQ(relation(kAtFirst, {0, 1}, {0, 0x1.000002p0F}), HitRelation::same) << "binary32 rounds";
  EXPECT_EQ(relation(kAtEdge, {0, 1}, {1, 1}), HitRelation::equal_distance) << "on the edge they share";
  EXPECT_EQ(relation(kAtFirst, {0, 1}, {3, 1}), HitRelation::equal_distance) << "in one another";
  EXPECT_EQ(relation({{0, 0, 0}, {-1, 0, 0}}, {}, {}), HitRelation::nothing);
}

TEST(CompareHit, a_nearer_hit_of_embree_that_is_exact_is_lost) {
  EXPECT_EQ(relation(kAtFirst, {}, {0, 1}), HitRelation::lost) << "we have none";
  EXPECT_EQ(relation(kAtFirst, {2, 2}, {0, 1}), HitRelation::lost) << "ours is farther";
  EXPECT_EQ(relation(kAtFirst, {1, 1.5}, {0, 1}), HitRelation::not_hit) << "a neighbour that is not hit";
  EXPECT_EQ(relation(kAtEdge, {2, 2}, {1, 1}), HitRelation::lost);
}

TEST(CompareHit, what_embree_rounds_is_its_own_mistake) {
  EXPECT_EQ(relation(kAtFirst, {0, 1}, {2, 2}), HitRelation::embree_rounds) << "its triangle is farther";
  EXPECT_EQ(relation(kAtFirst, {0, 1}, {}), HitRelation::embree_rounds) << "it has none";
  EXPECT_EQ(relation(kAtFirst, {0, 1}, {1, 1}), HitRelation::embree_rounds) << "its triangle is not hit";
  EXPECT_EQ(relation(kAside, {}, {0, 1}), HitRelation::embree_rounds) << "its triangle is not hit, and nothing else is";
}

TEST(CompareHit, a_distance_that_is_farther_off_than_embrees_is_wrong) {
  EXPECT_EQ(relation(kAtFirst, {0, 1.25}, {0, 1}), HitRelation::wrong_distance);
  EXPECT_EQ(relation(kAtFirst, {0, 1}, {0, 1.25F}), HitRelation::same) << "ours is the better one";
}

TEST(CompareHit, an_order_that_rounding_makes_is_no_loss) {
  // The triangle at 1 is exactly nearer; a farther one that says to be there is taken before it, by its number.
  EXPECT_EQ(relation(kAtFirst, {2, 0x1.fffffffffffffp-1}, {3, 1}), HitRelation::distance_rounds);
  EXPECT_EQ(relation(kAtFirst, {2, 1}, {3, 1}), HitRelation::distance_rounds);
  EXPECT_EQ(relation(kAtFirst, {2, 0x1.0000000000001p0}, {3, 1}), HitRelation::lost);
}

TEST(CompareHit, behind_the_end_of_a_ray_nothing_is_lost) {
  golden::Ray ray = kAtFirst;
  ray.t_max = 0.5F;
  EXPECT_EQ(relation(ray, {}, {0, 0.5F}), HitRelation::embree_rounds);
  ray.t_max = 1;
  EXPECT_EQ(relation(ray, {}, {0, 1}), HitRelation::lost);
}

TEST(RaySets, a_ray_depends_on_its_number_alone_and_is_what_its_set_says) {
  const golden::Mesh mesh = golden::load_scene("proc:spheres,triangles=500");
  const golden::Box box = golden::build_lbvh(mesh).scene;
  std::size_t through_vertices = 0;
  std::array<bool, 2> negative{};
  for (std::uint64_t i = 0; i < 2000; ++i) {
    for (const RaySet set : {RaySet::incoherent, RaySet::axis_parallel, RaySet::edges, RaySet::vertices}) {
      const golden::Ray ray = made_ray(set, mesh, box, 7, i);
      const golden::Ray again = made_ray(set, mesh, box, 7, i);
      ASSERT_EQ(ray.origin, again.origin);
      ASSERT_EQ(ray.direction, again.direction);
      ASSERT_NO_THROW(golden::check_ray(ray, "test"));
      ASSERT_NE(made_ray(set, mesh, box, 8, i).origin, ray.origin);
    }
    const golden::Ray ray = made_ray(RaySet::axis_parallel, mesh, box, 7, i);
    int zeros = 0;
    for (int axis = 0; axis < 3; ++axis) {
      if (ray.direction[axis] != 0) continue;
      ++zeros;
      negative[std::signbit(ray.direction[axis]) ? 1 : 0] = true;
    }
    ASSERT_EQ(zeros, 2);
    const auto on_the_line = [&](const glm::vec3& p) {
      int same = 0;
      for (int axis = 0; axis < 3; ++axis) same += ray.direction[axis] != 0 || p[axis] == ray.origin[axis] ? 1 : 0;
      return same == 3;
    };
    for (const glm::vec3& p : mesh.positions) {
      if (!on_the_line(p)) continue;
      ++through_vertices;
      break;
    }
  }
  EXPECT_GT(through_vertices, 800U);
  EXPECT_TRUE(negative[0] && negative[1]);
}

TEST(CompareHits, no_hit_is_lost_against_embree_through_either_tree) {
  HitsJob job;
  job.picture = {.camera = "inside", .rays = golden::RayKind::path, .samples = 1, .width = 32, .height = 24};
  job.rays = {4000, 4000, 4000, 4000};
  const golden::Mesh mesh = golden::load_scene("proc:spheres,triangles=2000");
  const TreePair trees = build_and_compress(mesh, {});
  std::vector<HitsResult> results;
  try {
    results = compare_hits(mesh, trees, job);
  } catch (const Unavailable&) {
    GTEST_SKIP() << "no Embree";
  }
  ASSERT_EQ(results.size(), 5U);
  for (const HitsResult& result : results) {
    EXPECT_EQ(result.wrong(), 0U) << result.set << ": " << result.mistakes[0];
    EXPECT_GE(result.rays, result.set == "picture" ? 768U : 4000U);
    EXPECT_GT(result.relations[static_cast<std::size_t>(HitRelation::same)], result.rays / 40) << result.set;
  }
  EXPECT_GT(results[2].relations[static_cast<std::size_t>(HitRelation::equal_distance)], 50U) << "through vertices";

  TreePair broken = trees;
  for (golden::FloatPair& pair : broken.floats.pairs) {
    for (golden::Box& box : pair.child) box.upper.x -= (box.upper.x - box.lower.x) * 0.25F;
  }
  results = compare_hits(mesh, broken, job);
  for (const HitsResult& result : results) {
    EXPECT_GT(result.relations[static_cast<std::size_t>(HitRelation::lost)], 10U) << result.set;
    EXPECT_GT(result.tree_differences, 10U) << result.set;
    EXPECT_EQ(result.mistakes.size(), 10U);
  }
}

TEST(OneRay, text_that_is_no_ray_is_refused) {
  EXPECT_EQ(parse_ray("--ray", "1,2,3,0,0,-1").direction, glm::vec3(0, 0, -1));
  EXPECT_EQ(parse_ray("--ray", "1,2,3,0,0,-1,0.5,inf").t_min, 0.5F);
  for (const char* text : {"", "1,2,3", "1,2,3,4,5,6,7", "1,2,3,4,5,6,7,8,9", "1,2,3,4,5,x", "1,2,3,0,0,0",
                           "nan,2,3,4,5,6", "1,2,3,inf,5,6", "1,2,3,4,5,6,2,1", "1,2,3,4,5,6,nan,1", "1,2,3,4,5,6,"})
    EXPECT_THROW(parse_ray("--ray", text), golden::InputError) << text;
}

}  // namespace
}  // namespace cbvh::testbench
