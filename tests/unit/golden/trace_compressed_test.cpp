// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "golden/build/builder.h"
#include "golden/build/lbvh.h"
#include "golden/quantize/scale.h"
#include "golden/scene/load.h"
#include "golden/scene/trouble_scenes.h"
#include "golden/trace/compressed_view.h"
#include "golden/trace/traverse.h"
#include "golden/update/refit.h"
#include "golden/update/streaming.h"
#include "golden/update/top_down.h"
#include "tests/unit/golden/awkward_rays.h"

namespace cbvh::golden {
namespace {

struct NamedTree {
  std::string name;
  CompressedTree tree;
};

GridRules rules_for(const FloatTree& tree, int bits) {
  GridRules rules;
  rules.bits = bits;
  rules.min_scale = exactness_limit(tree.largest_magnitude);
  return rules;
}

/// The topology of other triangles, those of the mesh in reverse order, around the mesh's own.
FloatTree refitted_from_other_triangles(const Mesh& mesh) {
  Mesh other = mesh;
  std::reverse(other.triangles.begin(), other.triangles.end());
  return refit(build_lbvh(other), mesh);
}

/// Every N and both codes: top-down, streamed without and with treelets, and streamed around refitted boxes.
std::vector<NamedTree> compressed_trees(const FloatTree& tree, const FloatTree& refitted) {
  std::vector<NamedTree> trees;
  for (const int bits : {2, 4, 6, 8}) {
    for (const Code code : {Code::modulo, Code::relative}) {
      const std::string suffix = " N=" + std::to_string(bits) + (code == Code::modulo ? " modulo" : " relative");
      trees.push_back({"top-down" + suffix, compress_top_down(tree, rules_for(tree, bits), code)});
      for (const int levels : {1, 3}) {
        trees.push_back({"treelets of " + std::to_string(levels) + suffix,
                         compress_streaming(tree, rules_for(tree, bits), code, levels).tree});
      }
      trees.push_back({"refitted" + suffix, compress_streaming(refitted, rules_for(refitted, bits), code, 2).tree});
    }
  }
  return trees;
}

/// Traces rays through the float tree and every compressed one; counts those that hit.
void expect_equal_hits(const Mesh& mesh, std::uint64_t seed, int rays, std::size_t& traced, std::size_t& hits) {
  const FloatTree tree = build_lbvh(mesh);
  std::vector<Ray> tried;
  std::vector<Hit> wanted;
  Tracer reference{FloatTreeView(tree), mesh};
  AwkwardRays source(mesh, seed);
  for (int i = 0; i < rays; ++i) {
    Ray ray = source.next(i % 5);
    if (!can_be_traced(ray)) continue;
    if (i % 6 == 0) ray.t_min = 0.75F;
    if (i % 7 == 0) ray.t_max = 1.0F;
    tried.push_back(ray);
    wanted.push_back(reference.trace(ray, Stop::closest));
    hits += wanted.back().primitive == Hit::kNone ? 0 : 1;
  }
  traced += tried.size();
  for (const NamedTree& compressed : compressed_trees(tree, refitted_from_other_triangles(mesh))) {
    Tracer tracer{CompressedTreeView(compressed.tree), mesh};
    for (std::size_t i = 0; i < tried.size(); ++i) {
      const std::string which = mesh.name + ", " + compressed.name + ", ray " + std::to_string(i);
      ASSERT_EQ(tracer.trace(tried[i], Stop::closest), wanted[i]) << which;
      ASSERT_EQ(tracer.trace(tried[i], Stop::never), wanted[i]) << which;
      ASSERT_EQ(tracer.trace(tried[i], Stop::any) == Hit(), wanted[i] == Hit()) << which;
    }
  }
}

TEST(TraceCompressed, hits_in_every_compressed_tree_are_those_of_the_float_tree_in_trouble_scenes) {
  std::size_t rays = 0;
  std::size_t hits = 0;
  for (std::uint64_t id = 0; id < 24; ++id) {
    const Mesh mesh = trouble_scene(kTroubles[id % kTroubles.size()], id);
    ASSERT_NO_FATAL_FAILURE(expect_equal_hits(mesh, id, 50, rays, hits));
  }
  EXPECT_GT(rays, 900U);
  EXPECT_GT(hits, rays / 4);
}

TEST(TraceCompressed, hits_in_every_compressed_tree_are_those_of_the_float_tree_in_procedural_scenes) {
  std::size_t rays = 0;
  std::size_t hits = 0;
  for (const std::string& name : procedural_scene_names()) {
    if (name == "cloth") continue;  // of one size, a large one
    const Mesh mesh = load_scene("proc:" + name + ",triangles=600");
    ASSERT_NO_FATAL_FAILURE(expect_equal_hits(mesh, 7, 40, rays, hits));
  }
  EXPECT_GT(rays, 150U);
  EXPECT_GT(hits, rays / 4);
}

/// Every pair whose node the ray passes, from all decoded boxes at once: no stack, no contexts.
TraceCounts counts_of_all_boxes(const CompressedTree& tree, const Ray& ray) {
  const PreparedRay prepared(ray);
  const std::vector<std::array<Box, 2>> boxes = decode_boxes(tree);
  TraceCounts counts;
  counts.box_tests = 1;
  const auto open = [&] {
    ++counts.pairs;
    counts.box_tests += 2;
  };
  if (prepared.inside(tree.scene).empty()) return counts;
  open();
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    for (std::size_t c = 0; c < 2; ++c) {
      const CompressedChild& child = tree.pairs[i].child[c];
      if (prepared.inside(boxes[i][c]).empty()) continue;
      if (!child.leaf) open();
      for (std::size_t entry = child.pointer; child.leaf; ++entry) {
        ++counts.triangle_tests;
        if ((tree.primitive_ids[entry] & kLastOfLeaf) != 0) break;
      }
    }
  }
  return counts;
}

TEST(TraceCompressed, rays_that_never_stop_test_the_decoded_boxes_and_at_least_the_float_trees) {
  const Mesh mesh = load_scene("proc:soup,triangles=300,size=0.5");
  const FloatTree tree = build_lbvh(mesh);
  std::uint64_t more = 0;
  for (const int bits : {2, 4, 6, 8}) {
    for (const Code code : {Code::modulo, Code::relative}) {
      const CompressedTree compressed = compress_top_down(tree, rules_for(tree, bits), code);
      AwkwardRays source(mesh, 3);
      for (int i = 0; i < 100; ++i) {
        const Ray ray = source.next(0);
        if (!can_be_traced(ray)) continue;
        Tracer floats{FloatTreeView(tree), mesh};
        Tracer tracer{CompressedTreeView(compressed), mesh};
        floats.trace(ray, Stop::never);
        tracer.trace(ray, Stop::never);
        ASSERT_EQ(tracer.counts(), counts_of_all_boxes(compressed, ray)) << "N = " << bits << ", ray " << i;
        ASSERT_GE(tracer.counts().box_tests, floats.counts().box_tests);
        ASSERT_GE(tracer.counts().triangle_tests, floats.counts().triangle_tests);
        if (tracer.counts().box_tests > floats.counts().box_tests) ++more;
      }
    }
  }
  EXPECT_GT(more, 100U);
}

TEST(TraceCompressed, the_view_opens_what_the_golden_decodes) {
  std::size_t pairs = 0;
  for (const char* scene :
       {"proc:spheres,triangles=1000", "proc:hairball,triangles=500", "proc:terrain,triangles=500"}) {
    const FloatTree tree = build_lbvh(load_scene(scene));
    for (int bits = 2; bits <= 8; ++bits) {
      for (const ScaleRule rule : {ScaleRule::equation2, ScaleRule::figure5}) {
        const int limit = exactness_limit(tree.largest_magnitude);
        for (const int min_scale : {limit, limit + 16}) {
          const CompressedTree compressed =
              compress_top_down(tree, {bits, min_scale, rule}, bits % 2 == 0 ? Code::modulo : Code::relative);
          const std::vector<std::array<Box, 2>> boxes = decode_boxes(compressed);
          const CompressedTreeView view(compressed);
          std::vector<CompressedTreeView::Node> nodes(compressed.pairs.size());
          nodes.back() = view.root();
          visit_pairs<std::int64_t>(compressed, [&](std::uint32_t index, const auto& context, const auto&) {
            ASSERT_EQ(nodes[index].context, context) << scene << ", N = " << bits << ", pair " << index;
            const CompressedTreeView::Opened opened = view.open(nodes[index]);
            for (std::size_t c = 0; c < 2; ++c) {
              ASSERT_EQ(opened.box[c].lower, boxes[index][c].lower);
              ASSERT_EQ(opened.box[c].upper, boxes[index][c].upper);
              if (!opened.leaf[c]) nodes[opened.pointer[c]] = view.child(nodes[index], opened, c);
            }
            ++pairs;
          });
        }
      }
    }
  }
  EXPECT_GT(pairs, 20000U);
}

TEST(TraceCompressed, a_minimum_scale_below_the_exactness_limit_is_refused) {
  const Mesh mesh = load_scene("proc:soup,triangles=20");
  const FloatTree tree = build_lbvh(mesh);
  GridRules rules = rules_for(tree, 6);
  EXPECT_NO_THROW(CompressedTreeView(compress_top_down(tree, rules, Code::modulo)));
  --rules.min_scale;
  const CompressedTree finer = compress_top_down(tree, rules, Code::modulo);
  EXPECT_THROW(CompressedTreeView{finer}, InputError);
}

}  // namespace
}  // namespace cbvh::golden
