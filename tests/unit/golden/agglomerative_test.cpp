// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/build/two_level/agglomerative.h"

#include <gtest/gtest.h>

#include "golden/build/two_level/pair_search.h"
#include "golden/scene/procedural/random.h"
#include "golden/scene/trouble_scenes.h"
#include "golden/scene/two_level/two_level_scenes.h"
#include "tests/unit/golden/two_level_helpers.h"

namespace cbvh::golden {
namespace {

std::vector<Box> random_boxes(Random& random, std::size_t count, std::uint64_t lattice) {
  std::vector<Box> boxes;
  for (std::size_t i = 0; i < count; ++i) {
    glm::vec3 lower = random.in_cube(1);
    glm::vec3 extent{random.unit(), random.unit(), random.unit()};
    if (lattice > 0) {  // few different places and sizes: ties everywhere
      for (glm::length_t axis = 0; axis < 3; ++axis) {
        lower[axis] = static_cast<float>(random.bits() % lattice);
        extent[axis] = static_cast<float>(random.bits() % 2);
      }
    }
    boxes.push_back({lower, lower + extent});
  }
  return boxes;
}

/// The clustering of Bikker's part 6 once more, with lists of nodes, and the remedy for a pair that is the last item.
std::vector<Pairing> as_described(const std::vector<Box>& boxes) {
  std::vector<Box> list = boxes;
  const auto find_best_match = [&](std::size_t a) {
    double smallest = 1e300;
    std::size_t best = a;
    for (std::size_t b = 0; b < list.size(); ++b) {
      if (b == a) continue;
      double extent[3];
      for (int axis = 0; axis < 3; ++axis)
        extent[axis] = static_cast<double>(std::max(list[a].upper[axis], list[b].upper[axis])) -
                       static_cast<double>(std::min(list[a].lower[axis], list[b].lower[axis]));
      const double area = extent[0] * extent[1] + extent[1] * extent[2] + extent[2] * extent[0];
      if (area < smallest) {
        smallest = area;
        best = b;
      }
    }
    return best;
  };
  std::vector<Pairing> pairings;
  std::size_t a = 0;
  std::size_t b = find_best_match(a);
  while (list.size() > 1) {
    const std::size_t c = find_best_match(b);
    if (a == c) {
      pairings.push_back({static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b)});
      list[a] = unite(list[a], list[b]);
      list[b] = list.back();
      if (a == list.size() - 1) a = b;
      list.pop_back();
      b = find_best_match(a);
    } else {
      a = b;
      b = c;
    }
  }
  return pairings;
}

TEST(Agglomerative, both_searches_pair_as_described_ties_and_duplicates_included) {
  Random random(1);
  std::size_t pairings = 0;
  for (int i = 0; i < 400; ++i) {
    const std::size_t count = 1 + random.bits() % 80;
    const std::vector<Box> boxes = random_boxes(random, count, static_cast<std::uint64_t>(i % 4) * 2);
    const std::vector<Pairing> wanted = as_described(boxes);
    ASSERT_EQ(wanted.size(), count - 1);
    ASSERT_EQ(nearest_pairings(boxes, PairSearch::scan), wanted) << i;
    ASSERT_EQ(nearest_pairings(boxes, PairSearch::tree), wanted) << i;
    pairings += wanted.size();
  }
  EXPECT_GT(pairings, 10'000U);
}

TEST(Agglomerative, both_searches_agree_on_every_kind_of_trouble) {
  for (std::uint64_t id = 0; id < 300; ++id) {
    const Mesh mesh = trouble_scene(kTroubles[id % kTroubles.size()], id, 120);
    const std::vector<Box> boxes = triangle_boxes(mesh);
    ASSERT_EQ(nearest_pairings(boxes, PairSearch::tree), nearest_pairings(boxes, PairSearch::scan)) << mesh.name;
  }
}

TEST(Agglomerative, a_thousand_equal_boxes_are_paired_in_order) {
  const std::vector<Box> boxes(1000, Box{{0, 0, 0}, {1, 1, 1}});
  EXPECT_EQ(nearest_pairings(boxes, PairSearch::tree), nearest_pairings(boxes, PairSearch::scan));
}

TEST(Agglomerative, by_hand_boxes_on_a_line) {
  // Places 0, 10, 11, 30: from 0 to its nearest 10, from there to 11, which is mutual. Then {10, 11} with 0, then 30.
  std::vector<Box> boxes;
  for (const float x : {0.0F, 10.0F, 11.0F, 30.0F}) boxes.push_back({{x, 0, 0}, {x + 1, 1, 1}});
  // {1, 2} are paired in place 1, the last, 30, moves to place 2; with place 0 they are paired in place 1, 30 moves to
  // place 0.
  EXPECT_EQ(nearest_pairings(boxes, PairSearch::scan), (std::vector<Pairing>{{1, 2}, {1, 0}, {1, 0}}));
}

/// What the article prints pairs the new pair, if it was the last of the list, with itself: the list is shortened and
/// its old place still holds the pair, which now also is at the place of the other.
TEST(Agglomerative, erratum_a_pair_that_is_the_last_of_the_list_moves) {
  std::vector<Box> boxes;
  // From 30 to its nearest, 11, the last of the list; from there to 10 and back.
  for (const float x : {30.0F, 10.0F, 11.0F}) boxes.push_back({{x, 0, 0}, {x + 1, 1, 1}});
  const std::vector<Pairing> pairings = nearest_pairings(boxes, PairSearch::scan);
  ASSERT_EQ(pairings.size(), 2U);
  EXPECT_EQ(pairings[0], (Pairing{2, 1}));
  EXPECT_EQ(pairings[1], (Pairing{1, 0}));
}

TEST(Agglomerative, the_tree_holds_every_instance_once_in_conservative_boxes) {
  for (const char* spec : {"bounce,count=1:proc:soup,triangles=20", "bounce,count=2,size=1:proc:soup,triangles=20",
                           "bounce,count=100,size=0.3,time=2:proc:soup,triangles=20",
                           "deal,objects=30:proc:spheres,triangles=800,spheres=5"}) {
    const BuiltScene scene(load_two_level_scene(spec));
    const TopLevel tree = scene.build("agglomerative");
    EXPECT_EQ(tree.references.size(), scene.scene.instances.size());
    EXPECT_EQ(faults_of(tree, scene.trees()), std::vector<std::string>{}) << spec;
    expect_same(tree, scene.build("agglomerative,search=scan"));
    expect_compresses(tree);
  }
}

}  // namespace
}  // namespace cbvh::golden
