// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/trace/pixel_tracer.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <set>
#include <string>
#include <vector>

#include "golden/build/lbvh.h"
#include "golden/quantize/scale.h"
#include "golden/scene/load.h"
#include "golden/trace/compressed_view.h"
#include "golden/update/streaming.h"

namespace cbvh::golden {
namespace {

constexpr unsigned kWidth = 24;
constexpr unsigned kHeight = 16;

template <class View>
std::vector<Pixel<Hit>> picture(const View& view, const Mesh& mesh, const Camera& camera, RayKind kind,
                                unsigned samples) {
  PixelTracer tracer(TracedMesh(view, mesh), camera, kind, samples);
  std::vector<Pixel<Hit>> pixels;
  for (unsigned y = 0; y < kHeight; ++y) {
    for (unsigned x = 0; x < kWidth; ++x) pixels.push_back(tracer.trace(x, y, kWidth, kHeight));
  }
  return pixels;
}

TEST(PixelTracer, a_random_number_depends_on_its_key_and_its_place_alone) {
  std::set<double> seen;
  double sum = 0;
  for (std::uint64_t key = 0; key < 6000; ++key) {
    const auto sequence = [key] { return CounterRandom(key / 60, key / 6 % 10, key % 6); };
    CounterRandom random = sequence();
    CounterRandom again = sequence();
    for (int i = 0; i < 4; ++i) {
      const double number = random.next();
      ASSERT_EQ(number, again.next());
      ASSERT_TRUE(number >= 0 && number < 1);
      ASSERT_TRUE(seen.insert(number).second) << "twice";
      sum += number;
    }
  }
  EXPECT_NEAR(sum / 24000, 0.5, 0.01);
}

TEST(PixelTracer, diffuse_directions_have_length_1_and_the_mean_cosine_two_thirds) {
  const glm::dvec3 normal = glm::normalize(glm::dvec3(0.3, -2, 1));
  glm::dvec3 sum(0);
  for (std::uint64_t i = 0; i < 20000; ++i) {
    CounterRandom random(i, 0, 0);
    const glm::dvec3 direction = diffuse_direction(normal, random);
    ASSERT_NEAR(glm::length(direction), 1, 1e-12);
    ASSERT_GT(glm::dot(direction, normal), 0);
    sum += direction;
  }
  EXPECT_LT(glm::length(sum / 20000.0 - normal * (2.0 / 3)), 0.01);
}

TEST(PixelTracer, pixels_are_the_same_through_every_tree_but_for_their_tests) {
  std::size_t hits = 0;
  std::uint64_t secondary = 0;
  std::uint64_t more = 0;
  for (const char* scene :
       {"proc:spheres,triangles=2000", "proc:city,triangles=1000", "proc:hairball,triangles=1000"}) {
    const Mesh mesh = load_scene(scene);
    const FloatTree tree = build_lbvh(mesh);
    GridRules rules;
    rules.min_scale = exactness_limit(tree.largest_magnitude);
    const CompressedTree compressed = compress_streaming(tree, rules, Code::modulo, 3).tree;
    const Camera camera = Camera::inside(tree.scene);
    for (const RayKind kind : {RayKind::primary, RayKind::occlusion, RayKind::path}) {
      const std::vector<Pixel<Hit>> wanted = picture(FloatTreeView(tree), mesh, camera, kind, 2);
      const std::vector<Pixel<Hit>> found = picture(CompressedTreeView(compressed), mesh, camera, kind, 2);
      for (std::size_t i = 0; i < wanted.size(); ++i) {
        ASSERT_EQ(found[i].hit, wanted[i].hit) << scene << ", pixel " << i;
        ASSERT_EQ(found[i].normal, wanted[i].normal) << scene << ", pixel " << i;
        ASSERT_EQ(found[i].light, wanted[i].light) << scene << ", pixel " << i;
        ASSERT_EQ(found[i].primary.rays, 1U);
        ASSERT_EQ(found[i].secondary.rays, wanted[i].secondary.rays) << scene << ", pixel " << i;
        ASSERT_GE(found[i].primary.tests.box_tests, 1U);
        ASSERT_TRUE(found[i].light >= 0 && found[i].light <= 1);
        hits += found[i].hit == Hit() ? 0 : 1;
        secondary += found[i].secondary.rays;
        if (found[i].secondary.tests.box_tests > wanted[i].secondary.tests.box_tests) ++more;
      }
    }
  }
  EXPECT_GT(hits, 300U);
  EXPECT_GT(secondary, 1000U);
  EXPECT_GT(more, 50U);
}

TEST(PixelTracer, nothing_hides_an_infinite_floor) {
  const Mesh mesh{"floor", {{-9000, 0, -9000}, {9000, 0, -9000}, {0, 0, 18000}}, {{0, 1, 2}}};
  const FloatTree tree = build_lbvh(mesh);
  const Camera camera("camera", {0, 10, 0}, {0, 0, 3}, {0, 1, 0}, 0.3);
  double light = 0;
  for (const Pixel<Hit>& pixel : picture(FloatTreeView(tree), mesh, camera, RayKind::occlusion, 3)) {
    ASSERT_EQ(pixel.light, 1);
    ASSERT_EQ(pixel.normal, glm::dvec3(0, 1, 0));
    ASSERT_EQ(pixel.secondary.rays, 3U);
  }
  for (const Pixel<Hit>& pixel : picture(FloatTreeView(tree), mesh, camera, RayKind::path, 16)) {
    ASSERT_EQ(pixel.secondary.rays, 16U) << "every path leaves at once";
    light += pixel.light;
  }
  EXPECT_NEAR(light / (kWidth * kHeight), kAlbedo * (0.5 + 0.5 * 2 / 3), 0.01);
}

TEST(PixelTracer, no_ray_leaves_a_closed_surface) {
  const Mesh mesh = load_scene("proc:spheres,spheres=1,triangles=500");
  const FloatTree tree = build_lbvh(mesh);
  const glm::dvec3 middle = (glm::dvec3(tree.scene.lower) + glm::dvec3(tree.scene.upper)) * 0.5;
  const Camera camera("camera", middle, middle + glm::dvec3(1, 0, 0), {0, 1, 0}, 0.5);
  for (const Pixel<Hit>& pixel : picture(FloatTreeView(tree), mesh, camera, RayKind::path, 2)) {
    ASSERT_NE(pixel.hit, Hit());
    ASSERT_EQ(pixel.light, 0);
    ASSERT_EQ(pixel.secondary.rays, 2U * kMostBounces);
  }
  double hidden = 0;
  std::size_t rays = 0;
  for (const Pixel<Hit>& pixel : picture(FloatTreeView(tree), mesh, camera, RayKind::occlusion, 200)) {
    hidden += (1 - pixel.light) * 200;
    rays += pixel.secondary.rays;
  }
  // The diagonal is sqrt(12) radii, a quarter of it 0.866; a chord from a point of the sphere is 2 cos radii long.
  EXPECT_NEAR(hidden / static_cast<double>(rays), 0.75 / 4, 0.02);
}

TEST(PixelTracer, a_camera_inside_a_box_looks_along_its_longest_side) {
  const Box box{{-1, -2, -3}, {1, 2, 7}};
  const Ray ray = Camera::inside(box).ray(1, 1, 3, 3);
  EXPECT_EQ(ray.origin, glm::vec3(0, 0, -2));
  EXPECT_EQ(ray.direction, glm::vec3(0, 0, 1));
}

}  // namespace
}  // namespace cbvh::golden
