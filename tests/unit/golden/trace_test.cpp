// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "golden/build/lbvh.h"
#include "golden/build/node_tree.h"
#include "golden/input_error.h"
#include "golden/scene/load.h"
#include "golden/scene/trouble_scenes.h"
#include "golden/trace/traverse.h"
#include "tests/unit/golden/awkward_rays.h"

namespace cbvh::golden {
namespace {

/// Another tree of the same triangles: in input order, one a leaf, split in the middle.
FloatTree tree_by_index(const Mesh& mesh) {
  const std::vector<Box> boxes = triangle_boxes(mesh);
  NodeTree tree;
  for (std::uint32_t id = 0; id < boxes.size(); ++id) tree.references.push_back(id);
  struct Range {
    std::uint32_t node, first, count;
  };
  tree.nodes.push_back({});
  std::vector<Range> open{{0, 0, static_cast<std::uint32_t>(boxes.size())}};
  while (!open.empty()) {
    const Range range = open.back();
    open.pop_back();
    if (range.count == 1) {
      tree.nodes[range.node] = {boxes[range.first], range.first, 1};
      continue;
    }
    const auto child = static_cast<std::uint32_t>(tree.nodes.size());
    tree.nodes[range.node] = {{}, child, 0};
    tree.nodes.resize(tree.nodes.size() + 2);
    const std::uint32_t half = range.count / 2;
    open.push_back({child, range.first, half});
    open.push_back({child + 1, range.first + half, range.count - half});
  }
  return emit(tree, boxes.size(), mesh.name);
}

/// Every triangle, no tree.
Hit nearest_of_all(const Mesh& mesh, const Ray& ray) {
  FloatTree leaf;
  leaf.primitives = static_cast<std::uint32_t>(mesh.triangles.size());
  for (std::uint32_t id = 0; id < leaf.primitives; ++id) leaf.primitive_ids.push_back(id);
  leaf.primitive_ids.back() |= kLastOfLeaf;
  leaf.scene = {glm::vec3(-INFINITY), glm::vec3(INFINITY)};
  return Tracer(FloatTreeView(leaf), mesh).trace(ray, Stop::closest);
}

TEST(Trace, the_nearest_hit_is_that_of_testing_every_triangle_whatever_the_tree) {
  std::size_t hits = 0;
  std::size_t rays = 0;
  for (std::uint64_t id = 0; id < 120; ++id) {
    const Mesh mesh = trouble_scene(kTroubles[id % kTroubles.size()], id);
    const FloatTree morton = build_lbvh(mesh);
    const FloatTree other = tree_by_index(mesh);
    Tracer first{FloatTreeView(morton), mesh};
    Tracer second{FloatTreeView(other), mesh};
    AwkwardRays source(mesh, id);
    for (int i = 0; i < 200; ++i) {
      Ray ray = source.next(i % 5);
      if (!can_be_traced(ray)) continue;
      if (i % 6 == 0) ray.t_min = 0.75F;
      if (i % 7 == 0) ray.t_max = 1.0F;
      const Hit wanted = nearest_of_all(mesh, ray);
      ASSERT_EQ(first.trace(ray, Stop::closest), wanted) << "scene " << id << ", ray " << i;
      ASSERT_EQ(second.trace(ray, Stop::closest), wanted) << "scene " << id << ", ray " << i;
      ASSERT_EQ(first.trace(ray, Stop::never), wanted) << "scene " << id << ", ray " << i;
      ASSERT_EQ(second.trace(ray, Stop::any).primitive == Hit::kNone, wanted.primitive == Hit::kNone);
      hits += wanted.primitive == Hit::kNone ? 0 : 1;
      ++rays;
    }
  }
  EXPECT_GT(rays, 15000U);
  EXPECT_GT(hits, rays / 4);
}

/// A plane that is none: its vertices are rounded.
Mesh tilted_sheet() {
  Mesh mesh{"sheet", {}, {}};
  constexpr unsigned kSide = 24;
  for (unsigned i = 0; i < kSide; ++i) {
    for (unsigned j = 0; j < kSide; ++j) {
      const glm::vec3 at(static_cast<float>(i) / 7, static_cast<float>(j) / 11, 0);
      mesh.positions.emplace_back(at.x, at.y, 0.3F * at.x - 0.7F * at.y);
    }
  }
  for (unsigned i = 0; i + 1 < kSide; ++i) {
    for (unsigned j = 0; j + 1 < kSide; ++j) {
      const unsigned a = i * kSide + j;
      mesh.triangles.emplace_back(a, a + 1, a + kSide);
      mesh.triangles.emplace_back(a + 1, a + kSide + 1, a + kSide);
    }
  }
  return mesh;
}

TEST(Trace, the_nearest_hit_does_not_depend_on_the_tree_where_t_is_hardly_determined) {
  const Mesh mesh = tilted_sheet();
  const std::vector<Box> boxes = triangle_boxes(mesh);
  const FloatTree morton = build_lbvh(mesh);
  const FloatTree other = tree_by_index(mesh);
  Tracer first{FloatTreeView(morton), mesh};
  Tracer second{FloatTreeView(other), mesh};
  AwkwardRays source(mesh, 5);
  std::size_t hits = 0;
  for (int i = 0; i < 20000; ++i) {
    const Ray ray = source.next(4);
    const Hit wanted = nearest_of_all(mesh, ray);
    ASSERT_EQ(first.trace(ray, Stop::closest), wanted) << "ray " << i;
    ASSERT_EQ(second.trace(ray, Stop::closest), wanted) << "ray " << i;
    if (wanted.primitive == Hit::kNone) continue;
    const Interval line = PreparedRay(ray).line_inside(boxes[wanted.primitive]);
    ASSERT_TRUE(line.entry <= wanted.t && wanted.t <= line.exit) << "ray " << i;
    ++hits;
  }
  EXPECT_GT(hits, 1000U);
}

TEST(Trace, no_ray_leaves_a_closed_surface_between_its_triangles) {
  const Mesh mesh = load_scene("proc:spheres,spheres=1,triangles=5000");
  const FloatTree tree = build_lbvh(mesh);
  Tracer tracer{FloatTreeView(tree), mesh};
  const glm::vec3 centre = tree.scene.lower * 0.5F + tree.scene.upper * 0.5F;
  std::size_t rays = 0;
  for (const glm::uvec3& triangle : mesh.triangles) {
    for (int corner = 0; corner < 3; ++corner) {
      const glm::vec3& a = mesh.positions[triangle[corner]];
      const glm::vec3& b = mesh.positions[triangle[(corner + 1) % 3]];
      for (const float part : {0.0F, 0.25F, 0.5F, 0.7F}) {
        const Hit hit = tracer.trace({centre, a + (b - a) * part - centre}, Stop::closest);
        ASSERT_NE(hit.primitive, Hit::kNone);
        ASSERT_NEAR(hit.t, 1, 0.01);
        ++rays;
      }
    }
  }
  EXPECT_EQ(rays, mesh.triangles.size() * 12);
}

class TraceOfATriangle : public ::testing::TestWithParam<glm::uvec3> {};

INSTANTIATE_TEST_SUITE_P(BothWindings, TraceOfATriangle, ::testing::Values(glm::uvec3(0, 1, 2), glm::uvec3(0, 2, 1)));

TEST_P(TraceOfATriangle, has_t_where_the_plane_is) {
  const Mesh mesh{"one", {{0, 0, 2}, {4, 0, 2}, {0, 4, 2}}, {GetParam()}};
  const FloatTree tree = build_lbvh(mesh);
  Tracer tracer{FloatTreeView(tree), mesh};
  EXPECT_EQ(tracer.trace({{1, 1, 0}, {0, 0, 0.5F}}, Stop::closest), (Hit{0, 4}));
  EXPECT_EQ(tracer.trace({{1, 1, 3}, {0, -0.0F, -1}}, Stop::closest), (Hit{0, 1}));
  EXPECT_EQ(tracer.trace({{1, 1, 3}, {0, 0, 1}}, Stop::closest), Hit()) << "behind the origin";
  EXPECT_EQ(tracer.trace({{1, 1, 0}, {0, 0, 1}, 2.5F}, Stop::closest), Hit()) << "before t_min";
  EXPECT_EQ(tracer.trace({{1, 1, 0}, {0, 0, 1}, 0, 1.5F}, Stop::closest), Hit()) << "beyond t_max";
  EXPECT_EQ(tracer.trace({{1, 1, 0}, {0, 0, 1}, 2, 2}, Stop::closest), (Hit{0, 2})) << "at both";
  EXPECT_EQ(tracer.trace({{3, 3, 0}, {0, 0, 1}}, Stop::closest), Hit()) << "beside the triangle";
  EXPECT_EQ(tracer.trace({{0, 0, 2}, {1, 0, 0}}, Stop::closest), Hit()) << "in its plane";
  for (const glm::vec3& origin : {glm::vec3(0), glm::vec3(4, 0, 0), glm::vec3(0, 4, 0), glm::vec3(2, 0, 0),
                                  glm::vec3(0, 3, 0), glm::vec3(1, 3, 0)}) {
    EXPECT_EQ(tracer.trace({origin, {0, 0, 1}}, Stop::closest), (Hit{0, 2})) << "its vertices and edges";
    EXPECT_EQ(tracer.trace({origin, {0, 0, -1}, -9}, Stop::closest), (Hit{0, -2})) << "from its other side";
  }
}

TEST(Trace, rays_that_never_stop_test_every_box_and_leaf_on_their_way) {
  const Mesh mesh = load_scene("proc:soup,triangles=400,size=0.5");
  const FloatTree tree = build_lbvh(mesh);
  AwkwardRays source(mesh, 3);
  std::uint64_t stopped_less = 0;
  for (int i = 0; i < 200; ++i) {
    const Ray ray = source.next(0);
    if (!can_be_traced(ray)) continue;
    Tracer never{FloatTreeView(tree), mesh};
    Tracer closest{FloatTreeView(tree), mesh};
    never.trace(ray, Stop::never);
    closest.trace(ray, Stop::closest);
    const PreparedRay prepared(ray);
    TraceCounts wanted;
    wanted.box_tests = 1;
    for (const FloatPair& pair : tree.pairs) {
      if (prepared.inside(own_box(pair)).empty()) continue;
      ++wanted.pairs;
      wanted.box_tests += 2;
      for (int c = 0; c < 2; ++c) {
        if (!pair.leaf[c] || prepared.inside(pair.child[c]).empty()) continue;
        std::size_t entry = pair.pointer[c];
        do {
          ++wanted.triangle_tests;
        } while ((tree.primitive_ids[entry++] & kLastOfLeaf) == 0);
      }
    }
    ASSERT_EQ(never.counts(), wanted);
    ASSERT_LE(closest.counts().box_tests, wanted.box_tests);
    if (closest.counts().triangle_tests < wanted.triangle_tests) ++stopped_less;
  }
  EXPECT_GT(stopped_less, 50U);
}

TEST(Trace, rays_that_are_none_are_refused_by_name) {
  const auto refused = [](const Ray& ray) -> std::string {
    try {
      check_ray(ray, "ray 7");
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(refused({{0, 0, 0}, {0, -0.0F, 0}}), "ray 7: direction: found 0 0 0, wanted a component that is not zero");
  EXPECT_EQ(refused({{0, NAN, 0}, {0, 1, 0}}), "ray 7: origin y: found nan, wanted a finite number");
  EXPECT_EQ(refused({{0, 0, 0}, {0, 1, INFINITY}}), "ray 7: direction z: found inf, wanted a finite number");
  EXPECT_EQ(refused({{0, 0, 0}, {0, 1, 0}, 2, 1}), "ray 7: t from 2 to 1, wanted an interval");
  EXPECT_EQ(refused({{0, 0, 0}, {0, 1, 0}, NAN, 1}), "ray 7: t from nan to 1, wanted an interval");
  EXPECT_EQ(refused({{0, 0, 0}, {0, 1, 0}, 0, INFINITY}), "");
}

}  // namespace
}  // namespace cbvh::golden
