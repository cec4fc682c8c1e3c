// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/build/two_level/rebraid.h"

#include <gtest/gtest.h>

#include <set>

#include "golden/build/node_tree.h"
#include "golden/build/two_level/opener.h"
#include "golden/build/two_level/two_level_sah.h"
#include "golden/input_error.h"
#include "golden/scene/load.h"
#include "golden/scene/procedural/random.h"
#include "golden/scene/trouble_scenes.h"
#include "golden/scene/two_level/two_level_scenes.h"
#include "golden/tree/decode.h"
#include "tests/unit/golden/two_level_helpers.h"

namespace cbvh::golden {
namespace {

const char* const kBuilders[] = {
    "plain",
    "rebraid",
    "rebraid,width=4",
    "rebraid,open=leaves,triangles=1",
    "rebraid,open=leaves,width=4,space=30,order=cost",
    "rebraid,order=overlap,triangles=4",
    "rebraid,order=cost,extent=0.01,overlap=0,space=9",
    "rebraid,depth=7,open=leaves,triangles=3",
};

TEST(Rebraid, every_triangle_of_every_instance_once_in_conservative_boxes_and_compressed) {
  int opened = 0;
  for (const char* spec : kTwoLevelScenes) {
    const BuiltScene scene(load_two_level_scene(spec));
    for (const char* builder : kBuilders) {
      const TopLevel top = scene.build(builder);
      EXPECT_EQ(faults_of(top, scene.trees()), std::vector<std::string>{}) << spec << ' ' << builder;
      expect_compresses(top);
      if (top.references.size() > scene.scene.instances.size()) ++opened;
    }
  }
  EXPECT_GT(opened, 25);
}

TEST(Rebraid, scenes_of_trouble_build_and_every_triangle_is_enclosed) {
  Random random(7);
  for (std::uint64_t id = 0; id < 240; ++id) {
    TwoLevelScene scene{"trouble", {}, {}};
    for (std::uint64_t object = 0; object < 3; ++object)
      scene.objects.push_back(trouble_scene(kTroubles[(id + object * 5) % kTroubles.size()], id + object, 40));
    for (std::uint32_t i = 0; i < 7; ++i) {
      Instance instance{i % 3};
      if (i > 2) {  // turned, mirrored, and small enough for what is huge
        for (glm::length_t column = 0; column < 3; ++column) {
          for (glm::length_t row = 0; row < 3; ++row) instance.to_world[column][row] = random.between(-0.3F, 0.3F);
        }
      }
      scene.instances.push_back(instance);
    }
    const BuiltScene built(scene, id % 2 == 0 ? Code::modulo : Code::relative);
    for (const char* builder : {"plain", "rebraid,open=leaves,space=20,overlap=0", "agglomerative"}) {
      const TopLevel top = built.build(builder);
      ASSERT_EQ(faults_of(top, built.trees()), std::vector<std::string>{}) << id << ' ' << builder;
      const TopLevel over_compressed = TopLevelBuilder("test", builder).build(built.compressed_trees());
      ASSERT_EQ(faults_of(over_compressed, built.compressed_trees()), std::vector<std::string>{})
          << id << ' ' << builder;
      expect_compresses(over_compressed);
    }
  }
}

/// The boxes of references into compressed trees are the decoded ones: the same as decode_boxes says, in the world.
TEST(Rebraid, over_compressed_trees_boxes_are_the_decoded_ones_and_contexts_start_a_traversal) {
  int checks = 0;
  for (const Code code : {Code::modulo, Code::relative}) {
    for (const char* spec : kTwoLevelScenes) {
      const BuiltScene scene(load_two_level_scene(spec), code);
      const InstancedTrees trees = scene.compressed_trees();
      const TopLevel top = TopLevelBuilder("test", "rebraid,width=4,space=16").build(trees);
      EXPECT_EQ(faults_of(top, trees), std::vector<std::string>{}) << spec;
      expect_compresses(top);
      // Of every pair of every object: the box its parent holds, and the grid it is written on.
      struct Seen {
        Box box;
        Context<std::int64_t> context;
      };
      std::vector<std::vector<Seen>> seen;
      for (const CompressedTree& tree : scene.compressed) {
        seen.emplace_back(tree.pairs.size());
        visit_pairs<std::int64_t>(
            tree, [&](std::uint32_t pair, const Context<std::int64_t>& context, const PairCells<std::int64_t>& cells) {
              seen.back()[pair].context = context;
              for (std::size_t c = 0; c < 2; ++c) {
                if (!tree.pairs[pair].child[c].leaf)
                  seen.back()[tree.pairs[pair].child[c].pointer].box = to_box(cells[c], context);
              }
            });
        if (!tree.pairs.empty()) seen.back().back().box = tree.scene;
      }
      for (const FloatPair& pair : top.tree.pairs) {
        for (int c = 0; c < 2; ++c) {
          if (!pair.leaf[c]) continue;
          const SubtreeReference& to = top.references[top.tree.primitive_ids[pair.pointer[c]] & ~kLastOfLeaf];
          if (to.node.kind != ObjectNode::Kind::pair) continue;
          const Instance& instance = scene.scene.instances[to.instance];
          const Seen& wanted = seen[instance.object][to.node.index];
          const Box box = world_box(wanted.box, instance.to_world);
          ASSERT_EQ(pair.child[c].lower, box.lower);
          ASSERT_EQ(pair.child[c].upper, box.upper);
          for (std::size_t axis = 0; axis < 3; ++axis) {
            ASSERT_EQ(to.node.context[axis].scale, wanted.context[axis].scale);
            ASSERT_EQ(to.node.context[axis].lower, wanted.context[axis].lower);
          }
          ++checks;
        }
      }
    }
  }
  EXPECT_GT(checks, 500);
}

TEST(Rebraid, segments_never_overlap_and_a_split_shares_all_space) {
  std::size_t segments = 0;
  for (const char* spec : kTwoLevelScenes) {
    const BuiltScene scene(load_two_level_scene(spec));
    for (const std::uint64_t space : {1U, 2U, 4U, 50U}) {
      RebraidOptions options;
      options.places = space * scene.scene.instances.size();
      std::vector<Segment> all;
      build_rebraided(scene.trees(), options, [&](const Segment& segment, auto) { all.push_back(segment); });
      std::vector<std::uint32_t> leaf_places(options.places);
      std::set<std::uint32_t> nodes;
      for (const Segment& s : all) {
        EXPECT_LT(s.first, s.last);
        EXPECT_LE(s.last, s.end);
        EXPECT_LE(s.end, options.places);
        EXPECT_TRUE(nodes.insert(s.node).second) << "a node is written once";
        if (s.count() == 1) ++leaf_places[s.first];
        for (const Segment& other : all) {  // nested, or apart
          const bool apart = s.end <= other.first || other.end <= s.first;
          const bool nested =
              (s.first <= other.first && other.end <= s.end) || (other.first <= s.first && s.end <= other.end);
          EXPECT_TRUE(apart || nested);
        }
      }
      for (const std::uint32_t uses : leaf_places) EXPECT_LE(uses, 1U);
      segments += all.size();
    }
  }
  EXPECT_GT(segments, 1000U);
}

/// Two long objects that cross: opened once each, their halves separate. By hand.
TEST(Rebraid, a_segment_is_opened_while_there_is_space_and_the_rule_does_not_end_it) {
  std::size_t full = 0;
  std::size_t ended = 0;
  std::size_t goes_on = 0;
  for (const char* spec : kTwoLevelScenes) {
    const BuiltScene scene(load_two_level_scene(spec));
    for (const std::uint64_t space : {2U, 4U, 50U}) {
      RebraidOptions options;
      options.places = space * scene.scene.instances.size();
      struct Seen {
        Segment segment;
        bool ends;
      };
      std::vector<Seen> all;
      build_rebraided(scene.trees(), options, [&](const Segment& segment, std::span<const BuildReference> references) {
        WideBox box;
        for (const BuildReference& reference : references) box.enclose(reference.bounds);
        all.push_back({segment, options.rule.ends(references, box)});
        if (!segment.opening) return;
        EXPECT_EQ(narrowed(segment.bounds).lower, narrowed(box).lower);
        EXPECT_EQ(narrowed(segment.bounds).upper, narrowed(box).upper);
      });
      for (const Seen& seen : all) {
        const Segment& parent = seen.segment;
        std::uint32_t space_left = 0;
        int opening = 0;
        int halves = 0;
        for (const Seen& other : all) {
          const Segment& half = other.segment;
          if (half.levels + 1 != parent.levels || half.first < parent.first || half.end > parent.end) continue;
          ++halves;
          space_left += half.space();
          opening += half.opening ? 1 : 0;
        }
        if (parent.count() == 1 || !parent.opening) {
          EXPECT_EQ(opening, 0);
          continue;
        }
        ASSERT_EQ(halves, 2);
        EXPECT_EQ(opening, seen.ends || space_left == 0 ? 0 : 2);
        ++(seen.ends ? ended : space_left == 0 ? full : goes_on);
      }
    }
  }
  EXPECT_GT(full, 20U);
  EXPECT_GT(ended, 20U);
  EXPECT_GT(goes_on, 20U);
}

TEST(Rebraid, by_hand_two_rods_that_overlap_are_opened) {
  const auto rod = [](float y) {
    Mesh mesh{"rod", {}, {}};
    for (int i = 0; i < 4; ++i) {
      const auto x = static_cast<float>(4 * i);
      const auto first = static_cast<std::uint32_t>(mesh.positions.size());
      mesh.positions.insert(mesh.positions.end(), {{x, y, 0}, {x + 1, y + 2, 0}, {x, y, 1}});
      mesh.triangles.emplace_back(first, first + 1, first + 2);
    }
    return mesh;
  };
  const BuiltScene scene(TwoLevelScene{"rods", {rod(0), rod(1)}, {{0}, {1}}});
  const TopLevel plain = scene.build("plain");
  ASSERT_EQ(plain.references.size(), 2U);
  EXPECT_EQ(plain.tree.scene.upper, glm::vec3(13, 3, 1));
  const TopLevel top = scene.build("rebraid,space=2,triangles=1000");
  // Both are opened: halves of each, split between x = 5 and x = 8.
  ASSERT_EQ(top.references.size(), 4U);
  ASSERT_EQ(top.tree.pairs.size(), 3U);
  EXPECT_EQ(top.tree.pairs[2].child[0].upper.x, 5.0F);
  EXPECT_EQ(top.tree.pairs[2].child[1].lower.x, 8.0F);
  EXPECT_EQ(top.tree.pairs[2].child[0].upper.y, 3.0F);
  for (const SubtreeReference& to : top.references) EXPECT_EQ(to.node.kind, ObjectNode::Kind::pair);
  const Box world = world_of(scene.trees());
  EXPECT_LT(two_level_sah(top, scene.trees(), world), two_level_sah(plain, scene.trees(), world));
}

TEST(Rebraid, one_instance_or_instances_apart_are_never_opened) {
  const BuiltScene one(load_two_level_scene("bounce,count=1:proc:soup,triangles=100"));
  EXPECT_EQ(one.build("rebraid,space=100,open=leaves,overlap=0").references.size(), 1U);
  TwoLevelScene apart{"apart", {load_scene("proc:soup,triangles=100")}, {}};
  for (int i = 0; i < 3; ++i) {
    apart.instances.push_back({0});
    apart.instances.back().to_world[3][0] = static_cast<float>(10 * i);
  }
  const BuiltScene three(apart);
  EXPECT_EQ(three.build("rebraid,space=100,open=leaves,overlap=0").references.size(), 3U);
  for (Instance& instance : apart.instances) instance.to_world[3][0] *= 0.01F;
  EXPECT_GT(BuiltScene(apart).build("rebraid,space=100").references.size(), 3U);
}

TEST(Rebraid, estimated_counts_divide_the_parents_and_opening_stops_at_what_fits) {
  const BuiltScene scene(load_two_level_scene("deal,objects=1:proc:spheres,triangles=800,spheres=5"));
  const InstancedTrees trees = scene.trees();
  const std::vector<BuildReference> whole = whole_instances(trees);
  ASSERT_EQ(whole.size(), 1U);
  EXPECT_EQ(whole[0].primitives, scene.floats[0].primitives);
  std::vector<BuildReference> children;
  for (const std::uint32_t width : {2U, 4U}) {
    for (const std::size_t most : {2U, 3U, 4U, 9U}) {
      const Opener opener(trees, width, false);
      opener.open(whole[0], most, children);
      ASSERT_EQ(children.size(), std::min<std::size_t>(width, most));
      for (const BuildReference& child : children)
        EXPECT_EQ(child.primitives, (whole[0].primitives + children.size() - 1) / children.size());
    }
  }
}

TEST(Rebraid, the_array_bounds_the_references_and_the_depth_the_levels) {
  for (const char* spec : kTwoLevelScenes) {
    const BuiltScene scene(load_two_level_scene(spec));
    const std::size_t instances = scene.scene.instances.size();
    EXPECT_LE(scene.build("rebraid,space=3,extent=0,overlap=0,triangles=1000000").references.size(), 3 * instances);
    for (const int levels : {6, 7, 8}) {
      for (const char* builder : {"plain", "rebraid,space=50,extent=0,overlap=0,open=leaves"}) {
        const TopLevel top = scene.build(fmt::format("{},depth={}", builder, levels));
        EXPECT_LE(depth(top.tree), levels) << spec << builder;
        EXPECT_EQ(faults_of(top, scene.trees()), std::vector<std::string>{});
      }
    }
  }
}

TEST(Rebraid, only_instances_in_place_get_a_place_for_so_many_triangles) {
  const auto references = [](const char* spec, const char* builder) {
    return BuiltScene(load_two_level_scene(spec)).build(builder).references.size();
  };
  constexpr const char* kInPlace = "deal,objects=10,chunk=2:proc:soup,triangles=800";
  EXPECT_EQ(references(kInPlace, "rebraid,overlap=0,extent=0"), 20U);
  EXPECT_EQ(references(kInPlace, "rebraid,overlap=0,extent=0,triangles=10"), 80U);
  EXPECT_EQ(references(kInPlace, "rebraid,overlap=0,extent=0,triangles=100"), 20U) << "the greater number";
  constexpr const char* kTurned = "bounce,count=10,size=1:proc:soup,triangles=80";
  EXPECT_EQ(references(kTurned, "rebraid,overlap=0,extent=0,triangles=10"), 20U);
}

TEST(Rebraid, a_description_or_a_tree_that_does_not_fit_is_refused) {
  const BuiltScene scene(load_two_level_scene(kTwoLevelScenes[3]));
  const auto message = [&](const std::string& builder) -> std::string {
    try {
      scene.build(builder);
    } catch (const InputError& error) {
      return error.what();
    }
    return {};
  };
  EXPECT_NE(message("none").find("top level: found 'none', wanted one of agglomerative, plain, rebraid"),
            std::string::npos);
  EXPECT_NE(message("rebraid,extent=2").find("option extent"), std::string::npos);
  EXPECT_NE(message("rebraid,width=3").find("option width"), std::string::npos);
  EXPECT_NE(message("plain,depth=2").find("5 instances do not fit 2 levels"), std::string::npos)
      << message("plain,depth=2");
  InstancedTrees trees = scene.trees();
  std::swap(trees.trees[0], trees.trees[1]);
  trees.trees.pop_back();
  EXPECT_THROW(TopLevelBuilder("test", "plain").build(trees), InputError);
  const BuiltScene other(load_two_level_scene(kTwoLevelScenes[0]));
  trees = scene.trees();
  trees.trees[2] = object_tree(other.floats[0]);
  EXPECT_THROW(TopLevelBuilder("test", "plain").build(trees), InputError);
  const CompressedTree fine = compress_top_down(scene.floats[0], {.min_scale = -149}, Code::modulo);
  EXPECT_THROW(object_tree(fine, "fine"), InputError);
  EXPECT_NE(top_level_help().find("rebraid"), std::string::npos);
}

}  // namespace
}  // namespace cbvh::golden
