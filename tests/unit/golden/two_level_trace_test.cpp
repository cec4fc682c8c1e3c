// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "golden/build/lbvh.h"
#include "golden/build/two_level/two_level_sah.h"
#include "golden/scene/procedural/random.h"
#include "golden/scene/trouble_scenes.h"
#include "golden/scene/two_level/two_level_scenes.h"
#include "golden/trace/two_level/two_level_tracer.h"
#include "golden/tree/decode.h"
#include "tests/unit/golden/awkward_rays.h"
#include "tests/unit/golden/two_level_helpers.h"

namespace cbvh::golden {
namespace {

const std::vector<const char*> kTops{"plain", "agglomerative", "agglomerative,search=scan", "rebraid",
                                     "rebraid,open=leaves,space=20,overlap=0,extent=0,width=4"};

bool is_accepted(const TwoLevelScene& scene) {
  try {
    check_scene(scene);
  } catch (const InputError&) {
    return false;
  }
  return true;
}

/// Every triangle of every instance, no tree.
InstanceHit nearest_of_all(const TwoLevelScene& scene, const InstanceRays& rays, const Ray& ray) {
  InstanceHit nearest;
  for (std::uint32_t i = 0; i < scene.instances.size(); ++i) {
    const Mesh& mesh = scene.objects[scene.instances[i].object];
    const WideRay image = rays.image(ray, i);
    const TriangleTest test(image);
    const PreparedRay prepared(image);
    for (std::uint32_t id = 0; id < mesh.triangles.size(); ++id) {
      const glm::uvec3& corner = mesh.triangles[id];
      const glm::vec3& a = mesh.positions[corner.x];
      const glm::vec3& b = mesh.positions[corner.y];
      const glm::vec3& c = mesh.positions[corner.z];
      const std::optional<double> found = test(a, b, c);
      const Interval line = prepared.line_inside(triangle_box(a, b, c));
      if (!found || line.empty()) continue;
      const InstanceHit hit{i, id, std::min(std::max(*found, line.entry), line.exit)};
      if (!prepared.reaches(hit.t)) continue;
      if (hit.before(nearest)) nearest = hit;
    }
  }
  return nearest;
}

/// The same hit through every top level, over float and over compressed trees, and through the compressed top level.
class EveryTop {
 public:
  explicit EveryTop(const BuiltScene& scene) : rays(scene.scene) {
    forests.push_back(scene.trees());
    forests.push_back(scene.compressed_trees());
    for (const char* top : kTops) {
      for (const InstancedTrees& forest : forests) tops.push_back(TopLevelBuilder("test", top).build(forest));
      tops.push_back(compressed(tops.back()));
    }
    for (std::size_t i = 0; i < tops.size(); ++i)
      tracers.emplace_back(tops[i], forests[std::min(i % 3, std::size_t{1})], rays);
  }
  void expect(const Ray& ray, const InstanceHit& wanted) {
    for (std::size_t i = 0; i < tracers.size(); ++i) {
      ASSERT_EQ(tracers[i].trace(ray, Stop::closest), wanted) << kTops[i / 3] << ' ' << wanted.t;
      ASSERT_EQ(tracers[i].trace(ray, Stop::never), wanted) << kTops[i / 3];
      ASSERT_EQ(tracers[i].trace(ray, Stop::any).instance == Hit::kNone, wanted.instance == Hit::kNone);
    }
  }

  InstanceRays rays;

 private:
  static TopLevel compressed(TopLevel top) {
    const GridRules rules{.min_scale = exactness_limit(top.tree.largest_magnitude)};
    const auto boxes = decode_boxes(compress_top_down(top.tree, rules, Code::modulo));
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      for (std::size_t c = 0; c < 2; ++c) top.tree.pairs[i].child[c] = boxes[i][c];
    }
    return top;
  }

  std::vector<InstancedTrees> forests;
  std::vector<TopLevel> tops;
  std::vector<TwoLevelTracer> tracers;
};

/// Rotations, mirrors, shears, flat ones, and what moves boxes to where their coordinates round.
glm::mat4 transform(Random& random, std::uint64_t kind) {
  glm::mat4 m(1.0F);
  const auto part = [&] { return random.between(-0.3F, 0.3F); };
  for (glm::length_t column = 0; column < 3; ++column) {
    for (glm::length_t row = 0; row < 3; ++row) {
      if (kind == 1) m[column][row] = part();
      if (kind == 2) m[column][row] = row == (column + 1) % 3 ? 0.7F : 0.0F;  // axes stay axes
    }
    if (kind != 0) m[3][column] = random.between(-3.0F, 3.0F);
  }
  if (kind == 4) m[0] = m[1] + m[0] * 0x1p-18F;  // all but flat
  return m;
}

TEST(TwoLevelTrace, the_nearest_hit_is_that_of_testing_every_triangle_of_every_instance_whatever_the_top_level) {
  std::size_t rays = 0;
  std::size_t hits = 0;
  Random random(3);
  for (std::uint64_t id = 0; id < 60; ++id) {
    TwoLevelScene scene{"trouble", {}, {}};
    for (std::uint64_t object = 0; object < 2; ++object)
      scene.objects.push_back(trouble_scene(kTroubles[(id + object * 5) % kTroubles.size()], id + object, 24));
    for (std::uint32_t i = 0; i < 6; ++i) scene.instances.push_back({i % 2, transform(random, (id + i) % 5)});
    if (!is_accepted(scene)) continue;
    const Mesh all = flatten(scene);
    const BuiltScene built(std::move(scene), id % 2 == 0 ? Code::modulo : Code::relative);
    EveryTop every(built);
    AwkwardRays source(all, id);
    for (int i = 0; i < 250; ++i) {
      Ray ray = source.next(i % 5);
      if (!can_be_traced(ray)) continue;
      if (i % 6 == 0) ray.t_min = 0.75F;
      if (i % 7 == 0) ray.t_max = 1.0F;
      const InstanceHit wanted = nearest_of_all(built.scene, every.rays, ray);
      ASSERT_NO_FATAL_FAILURE(every.expect(ray, wanted)) << "scene " << id << ", ray " << i;
      hits += wanted.instance == Hit::kNone ? 0 : 1;
      ++rays;
    }
  }
  EXPECT_GT(rays, 9000U);
  EXPECT_GT(hits, rays / 4);
}

/// Instances whose world boxes end exactly at the origin, where a vertex of theirs is, and rays that miss those boxes
/// by 10^-20: their images are rounded, and some of them hit.
TEST(TwoLevelTrace, what_rounds_to_beside_a_world_box_is_hit_through_every_top_level) {
  Random random(9);
  const auto integer = [&random](int least) { return static_cast<float>(static_cast<int>(random.bits() % 7) + least); };
  const auto integers = [&](int least) { return glm::vec3(integer(least), integer(least), integer(least)); };
  int beside = 0;
  for (int scene_id = 0; scene_id < 60; ++scene_id) {
    TwoLevelScene scene{"corners", {{"triangles", {{0, 0, 0}}, {{0, 1, 2}, {0, 2, 3}}}}, {}};
    for (int i = 0; i < 3; ++i) scene.objects[0].positions.push_back(integers(0));
    const auto axis = static_cast<glm::length_t>(random.bits() % 3);
    const float side = scene_id % 2 == 0 ? 1.0F : -1.0F;  // of the origin the boxes are on
    for (int i = 0; i < 3; ++i) {
      glm::mat4 m(1.0F);
      for (glm::length_t column = 0; column < 3; ++column) {
        m[column] = glm::vec4(integers(-3), 0);
        m[column][axis] = side * std::abs(m[column][axis]);
      }
      scene.instances.push_back({0, m});
    }
    if (!is_accepted(scene)) continue;
    const BuiltScene built(std::move(scene));
    EveryTop every(built);
    for (int i = 0; i < 60; ++i) {
      Ray ray{{}, integers(-3)};
      ray.direction[axis] = 0;
      ray.origin = ray.direction * -97.0F;
      ray.origin[axis] = side * -1e-20F;
      if (!can_be_traced(ray)) continue;
      const InstanceHit wanted = nearest_of_all(built.scene, every.rays, ray);
      ASSERT_NO_FATAL_FAILURE(every.expect(ray, wanted)) << "scene " << scene_id << ", ray " << i;
      ASSERT_TRUE(PreparedRay(ray).inside(world_of(built.trees())).empty());
      beside += wanted.instance == Hit::kNone ? 0 : 1;
    }
  }
  EXPECT_GT(beside, 1000);
}

TEST(TwoLevelTrace, where_an_inverse_is_hardly_determined_every_instance_is_looked_at) {
  TwoLevelScene scene = load_two_level_scene("bounce,count=4,size=0.7:proc:soup,triangles=40,size=0.5");
  scene.instances[0].to_world[0] = {1 + 0x1p-23F, 1, 0, 0};
  scene.instances[0].to_world[1] = {1, 1 - 0x1p-23F, 0, 0};
  check_scene(scene);
  const Mesh all = flatten(scene);
  const BuiltScene built(std::move(scene));
  EveryTop every(built);
  AwkwardRays source(all, 2);
  for (int i = 0; i < 200; ++i) {
    const Ray ray = source.next(i % 4);
    if (!can_be_traced(ray)) continue;
    ASSERT_EQ(every.rays.slack(ray), std::numeric_limits<double>::infinity());
    ASSERT_NO_FATAL_FAILURE(every.expect(ray, nearest_of_all(built.scene, every.rays, ray))) << i;
  }
}

TEST(TwoLevelTrace, of_instances_that_are_not_transformed_the_hits_are_those_of_one_tree_over_all_triangles) {
  for (const char* spec : {"deal,objects=7,chunk=3:proc:spheres,triangles=800,spheres=5",
                           "deal,objects=20,chunk=1:proc:terrain,triangles=600"}) {
    const BuiltScene scene(load_two_level_scene(spec));
    EveryTop every(scene);
    const Mesh all = flatten(scene.scene);
    std::vector<InstanceHit> source;  // of each triangle of the flat scene
    for (std::uint32_t i = 0; i < scene.scene.instances.size(); ++i) {
      const auto triangles = scene.scene.objects[scene.scene.instances[i].object].triangles.size();
      for (std::uint32_t id = 0; id < triangles; ++id) source.push_back({i, id, 0});
    }
    const FloatTree tree = build_lbvh(all);
    Tracer single{FloatTreeView(tree), all};
    AwkwardRays rays(all, 11);
    int hits = 0;
    for (int i = 0; i < 400; ++i) {
      const Ray ray = rays.next(i % 5);
      if (!can_be_traced(ray)) continue;
      const Hit hit = single.trace(ray, Stop::closest);
      InstanceHit wanted;
      if (hit.primitive != Hit::kNone) {
        wanted = source[hit.primitive];
        wanted.t = hit.t;
        ++hits;
      }
      ASSERT_NO_FATAL_FAILURE(every.expect(ray, wanted)) << spec << ", ray " << i;
    }
    EXPECT_GT(hits, 100);
  }
}

TEST(TwoLevelTrace, by_hand_t_is_that_of_the_world_whatever_the_scale) {
  TwoLevelScene scene{"one", {{"triangle", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}}, {}};
  glm::mat4 larger(4.0F);  // and a quarter turn around z: x to y
  larger[0] = {0, 4, 0, 0};
  larger[1] = {-4, 0, 0, 0};
  larger[3] = {0, 0, 8, 1};
  scene.instances.push_back({0, larger});
  glm::mat4 behind(1.0F);
  behind[3] = {0, 0, 20, 1};
  scene.instances.push_back({0, behind});
  const BuiltScene built(std::move(scene));
  EveryTop every(built);
  every.expect({{-1, 1, 0}, {0, 0, 2}}, {0, 0, 4});          // (0.25, 0.25) of the larger one
  every.expect({{0.25F, 0.25F, 0}, {0, 0, 2}}, {1, 0, 10});  // beside it, onto the one behind
  every.expect({{-3, 3, 0}, {0, 0, 2}}, {});                 // beyond the long side
}

TEST(TwoLevelTrace, two_instances_at_the_same_place_give_the_first) {
  TwoLevelScene scene = load_two_level_scene("bounce,count=1,size=0.7:proc:soup,triangles=40,size=0.5");
  scene.instances.resize(5, scene.instances.front());
  const BuiltScene built(std::move(scene));
  EveryTop every(built);
  const Mesh all = flatten(built.scene);
  AwkwardRays source(all, 2);
  int hits = 0;
  for (int i = 0; i < 300; ++i) {
    const Ray ray = source.next(0);
    const InstanceHit wanted = nearest_of_all(built.scene, every.rays, ray);
    if (wanted.instance == Hit::kNone) continue;
    ASSERT_EQ(wanted.instance, 0U);
    ASSERT_NO_FATAL_FAILURE(every.expect(ray, wanted)) << i;
    ++hits;
  }
  EXPECT_GT(hits, 50);
}

TEST(TwoLevelTrace, an_image_of_a_ray_stays_within_its_slack) {
  Random random(5);
  const TwoLevelScene bounce = load_two_level_scene("bounce,count=50,size=0.3,time=3:proc:soup,triangles=20");
  const InstanceRays rays(bounce);
  for (std::uint32_t i = 0; i < bounce.instances.size(); ++i) {
    const Ray ray{random.in_cube(3), random.direction()};
    const WideRay image = rays.image(ray, i);
    const glm::mat4& m = bounce.instances[i].to_world;
    EXPECT_LT(rays.slack(ray), 1e-9);
    for (const double t : {0.0, 1.0, 2.5}) {
      for (glm::length_t row = 0; row < 3; ++row) {
        long double there = static_cast<long double>(m[3][row]);
        for (glm::length_t column = 0; column < 3; ++column)
          there += static_cast<long double>(m[column][row]) * (static_cast<long double>(image.origin[column]) +
                                                               t * static_cast<long double>(image.direction[column]));
        const long double here = ray.origin[row] + t * static_cast<long double>(ray.direction[row]);
        EXPECT_LE(std::abs(there - here), static_cast<long double>(rays.slack(ray)));
      }
    }
  }
}

TEST(TwoLevelTrace, counts_are_those_of_both_levels) {
  const BuiltScene scene(load_two_level_scene("bounce,count=20,size=0.4:proc:spheres,triangles=200,spheres=3"));
  const InstancedTrees trees = scene.trees();
  const TopLevel top = scene.build("plain");
  const InstanceRays rays(scene.scene);
  TwoLevelTracer tracer(top, trees, rays);
  TwoLevelTracer any(top, trees, rays);
  TwoLevelTracer closest(top, trees, rays);
  Random random(4);
  TwoLevelCounts wanted;
  for (int i = 0; i < 200; ++i) {
    const Ray ray{{-3, random.between(-1, 1), random.between(-1, 1)}, {1, 0.1F, 0.2F}};
    tracer.trace(ray, Stop::never);
    any.trace(ray, Stop::any);
    closest.trace(ray, Stop::closest);
    // Every pair whose box the ray meets, and each leaf it reaches.
    const PreparedRay prepared(ray);
    ++wanted.top.box_tests;
    for (const FloatPair& pair : top.tree.pairs) {
      if (prepared.inside(own_box(pair), rays.slack(ray)).empty()) continue;
      ++wanted.top.pairs;
      wanted.top.box_tests += 2;
      for (int c = 0; c < 2; ++c) {
        if (!pair.leaf[c] || prepared.inside(pair.child[c], rays.slack(ray)).empty()) continue;
        ++wanted.transforms;
        const std::uint32_t placed = top.references[top.tree.primitive_ids[pair.pointer[c]] & ~kLastOfLeaf].instance;
        const PreparedRay image(rays.image(ray, placed));
        const FloatTree& object = scene.floats[scene.scene.instances[placed].object];
        for (std::size_t node = 0; node < object.pairs.size(); ++node) {
          const bool root = node + 1 == object.pairs.size();  // entered whatever its box
          if (!root && image.inside(own_box(object.pairs[node])).empty()) continue;
          ++wanted.objects.pairs;
          wanted.objects.box_tests += 2;
          for (int child = 0; child < 2; ++child) {
            if (!object.pairs[node].leaf[child] || image.inside(object.pairs[node].child[child]).empty()) continue;
            wanted.objects.triangle_tests += leaf_size(object.primitive_ids, object.pairs[node].pointer[child]);
          }
        }
      }
    }
  }
  EXPECT_GT(wanted.transforms, 50U);
  EXPECT_GT(wanted.objects.triangle_tests, 10U);
  EXPECT_EQ(tracer.counts(), wanted);
  EXPECT_LT(any.counts().transforms, closest.counts().transforms);
  EXPECT_LT(closest.counts().transforms, wanted.transforms);
}

}  // namespace
}  // namespace cbvh::golden
