// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// Random rays: where they start, and that those across a box visit others as the surface area cost model says.
#include "golden/trace/random_rays.h"

#include <gtest/gtest.h>

#include <cmath>

#include "built_tree_checks.h"
#include "golden/scene/load.h"
#include "golden/trace/traverse.h"
#include "golden/tree/sah.h"

namespace cbvh::golden {
namespace {

constexpr Box kBox{{-1, 2, 0}, {3, 4, 1}};

TEST(RandomRays, start_everywhere_within_the_box_and_are_the_same_every_time) {
  glm::dvec3 sum(0);
  glm::dvec3 directions(0);
  constexpr std::uint64_t kRays = 20000;
  for (std::uint64_t i = 0; i < kRays; ++i) {
    const Ray ray = ray_from_within(kBox, i);
    for (int axis = 0; axis < 3; ++axis) {
      ASSERT_GE(ray.origin[axis], kBox.lower[axis]);
      ASSERT_LE(ray.origin[axis], kBox.upper[axis]);
    }
    check_ray(ray, "test");
    const Ray again = ray_from_within(kBox, i);
    ASSERT_TRUE(again.origin == ray.origin && again.direction == ray.direction);
    sum += glm::dvec3(ray.origin);
    directions += glm::dvec3(ray.direction);
  }
  // Means within five standard deviations.
  for (int axis = 0; axis < 3; ++axis) {
    const auto extent = static_cast<double>(kBox.upper[axis] - kBox.lower[axis]);
    const double middle = static_cast<double>(kBox.upper[axis] + kBox.lower[axis]) / 2;
    EXPECT_LT(std::abs(sum[axis] / kRays - middle), 5 * extent / std::sqrt(12.0 * kRays));
    EXPECT_LT(std::abs(directions[axis] / kRays), 5 / std::sqrt(3.0 * kRays));
  }
}

TEST(RandomRays, across_a_box_meet_a_box_in_it_as_often_as_its_surface_says) {
  constexpr std::uint64_t kRays = 50000;
  for (const Box& inner :
       {Box{{0, 2.5, 0.25}, {1, 3, 0.5}}, Box{{-1, 2, 0}, {-1, 4, 1}}, Box{{-1, 2, 0.5}, {3, 2.5, 1}}}) {
    std::uint64_t met = 0;
    for (std::uint64_t i = 0; i < kRays; ++i) {
      const PreparedRay ray(ray_across(kBox, i));
      ASSERT_FALSE(ray.inside(kBox).empty());
      met += ray.inside(inner).empty() ? 0 : 1;
    }
    const double share = half_area(inner) / half_area(kBox);
    const double deviation = std::sqrt(share * (1 - share) / static_cast<double>(kRays));
    EXPECT_LT(std::abs(static_cast<double>(met) / kRays - share), 5 * deviation);
  }
}

TEST(RandomRays, across_the_scene_cost_on_average_what_the_surface_area_heuristic_expects) {
  const Mesh mesh = load_scene("rotated:proc:city,triangles=1000");
  constexpr std::uint64_t kRays = 20000;
  for (const char* const builder : {"sweep", "spatial", "generic,overlap=1e16"}) {
    const FloatTree tree = build(builder, mesh);
    Tracer tracer(FloatTreeView(tree), mesh);
    for (std::uint64_t i = 0; i < kRays; ++i) tracer.trace(ray_across(tree.scene, i), Stop::never);
    const auto cost = static_cast<double>(tracer.counts().pairs + tracer.counts().triangle_tests) / kRays;
    EXPECT_NEAR(cost / sah(tree), 1, 0.05) << builder;  // 20,000 rays, which differ by about as much as they cost
  }
}

}  // namespace
}  // namespace cbvh::golden
