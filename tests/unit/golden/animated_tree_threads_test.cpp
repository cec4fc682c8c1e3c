// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <chrono>
#include <cstring>
#include <glm/vec3.hpp>

#include "golden/build/lbvh.h"
#include "golden/input_error.h"
#include "golden/scene/load.h"
#include "golden/update/animated_tree.h"
#include "golden/update/refit.h"

namespace cbvh::golden {
namespace {

std::shared_ptr<const Mesh> frame(double time) {
  return std::make_shared<const Mesh>(load_scene(fmt::format("proc:explode,triangles=2000,time={}", time)));
}

bool same_boxes(const FloatTree& a, const FloatTree& b) {
  if (a.pairs.size() != b.pairs.size()) return false;
  for (std::size_t i = 0; i < a.pairs.size(); ++i) {
    if (std::memcmp(a.pairs[i].child, b.pairs[i].child, sizeof a.pairs[i].child) != 0) return false;
  }
  return true;
}

TEST(AsyncRebuild, gives_the_builders_tree_once) {
  const auto mesh = frame(0.25);
  AsyncRebuild beside(Builder("test", "lbvh"));
  EXPECT_TRUE(beside.idle());
  EXPECT_FALSE(beside.take());
  for (int i = 0; i < 20; ++i) {
    beside.start(mesh);
    EXPECT_FALSE(beside.idle());
    beside.wait();
    const std::optional<FloatTree> tree = beside.take();
    ASSERT_TRUE(tree);
    EXPECT_TRUE(same_boxes(*tree, build_lbvh(*mesh)));
    EXPECT_TRUE(beside.idle());
    EXPECT_FALSE(beside.take());
  }
}

TEST(AsyncRebuild, hands_on_what_the_builder_throws_and_goes_on) {
  AsyncRebuild beside(Builder("test", "lbvh"));
  beside.start(std::make_shared<const Mesh>(Mesh{"empty", {}, {}}));
  beside.wait();
  EXPECT_THROW(beside.take(), InputError);
  EXPECT_TRUE(beside.idle());
  beside.start(frame(0));
  beside.wait();
  EXPECT_TRUE(beside.take());
}

TEST(AsyncRebuild, may_end_while_a_tree_is_being_built) {
  for (int i = 0; i < 20; ++i) {
    AsyncRebuild beside(Builder("test", "lbvh"));
    beside.start(frame(0));
  }
}

/// Frames 0, 1, ... of a burst; `check` sees the tree that a policy has for each.
template <class Check>
void run(UpdatePolicy policy, int frames, double rebuild_above, Check check) {
  AnimatedTree tree(Builder("test", "lbvh"), {policy, 2, rebuild_above});
  for (int i = 0; i < frames; ++i) {
    const auto mesh = frame(i / 10.0);
    const FloatTree& current = tree.advance(mesh);
    ASSERT_TRUE(same_boxes(current, refit(current, *mesh))) << "boxes of another frame, frame " << i;
    check(i, current, tree, *mesh);
  }
}

TEST(AnimatedTree, refit_keeps_the_first_frames_tree) {
  const FloatTree first = build_lbvh(*frame(0));
  run(UpdatePolicy::refit, 6, 2, [&](int i, const FloatTree& current, const AnimatedTree& tree, const Mesh& mesh) {
    EXPECT_TRUE(same_boxes(current, refit(first, mesh)));
    EXPECT_EQ(tree.age(), static_cast<unsigned>(i));
    EXPECT_EQ(tree.rebuilds(), 1U);
  });
}

TEST(AnimatedTree, rebuild_builds_every_frame) {
  run(UpdatePolicy::rebuild, 6, 2, [&](int i, const FloatTree& current, const AnimatedTree& tree, const Mesh& mesh) {
    EXPECT_TRUE(same_boxes(current, build_lbvh(mesh)));
    EXPECT_EQ(tree.age(), 0U);
    EXPECT_EQ(tree.rebuilds(), static_cast<unsigned>(i) + 1);
  });
}

double surface(const Box& box) {
  const glm::dvec3 size = glm::dvec3(box.upper) - glm::dvec3(box.lower);
  return 2 * (size.x * size.y + size.y * size.z + size.z * size.x);
}

double growth(const FloatTree& built, const FloatTree& now) {
  double sum = 0;
  for (std::size_t i = 0; i < built.pairs.size(); ++i) {
    const auto ratio = [i](const FloatTree& tree) {
      const Box* const child = tree.pairs[i].child;
      return surface(unite(child[0], child[1])) / (surface(child[0]) + surface(child[1]));
    };
    sum += ratio(now) / ratio(built);
  }
  return sum / static_cast<double>(built.pairs.size());
}

TEST(AnimatedTree, heuristic_builds_when_nodes_have_grown_by_its_factor_against_their_children) {
  FloatTree built;
  FloatTree wanted;
  unsigned rebuilds = 0;
  run(UpdatePolicy::heuristic, 12, 1.5,
      [&](int i, const FloatTree& current, const AnimatedTree& tree, const Mesh& mesh) {
        const FloatTree refitted = i == 0 ? FloatTree() : refit(built, mesh);
        const bool builds = i == 0 || growth(built, refitted) > 1.5;
        wanted = builds ? build_lbvh(mesh) : refitted;
        if (builds) built = wanted;
        rebuilds += builds ? 1 : 0;
        EXPECT_TRUE(same_boxes(current, wanted)) << "frame " << i;
        EXPECT_EQ(tree.rebuilds(), rebuilds);
        EXPECT_EQ(tree.age() == 0, builds);
      });
  EXPECT_GT(rebuilds, 1U);
  EXPECT_LT(rebuilds, 12U);
}

TEST(AnimatedTree, async_takes_trees_of_earlier_frames_and_says_how_old_they_are) {
  std::vector<std::shared_ptr<const Mesh>> frames;
  std::vector<FloatTree> built;
  for (int i = 0; i < 40; ++i) {
    frames.push_back(frame(i / 20.0));
    built.push_back(build_lbvh(*frames.back()));
  }
  AnimatedTree tree(Builder("test", "lbvh"), {UpdatePolicy::async, 1, 2});
  const auto give_up = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  unsigned i = 0;
  for (; tree.rebuilds() < 6 && std::chrono::steady_clock::now() < give_up; ++i) {
    const auto& mesh = frames[i % frames.size()];
    const FloatTree& current = tree.advance(mesh);
    ASSERT_LE(tree.age(), i);
    const FloatTree& origin = built[(i - tree.age()) % frames.size()];
    ASSERT_TRUE(same_boxes(current, refit(origin, *mesh))) << "frame " << i << ", age " << tree.age();
  }
  EXPECT_GE(tree.rebuilds(), 6U) << "in " << i << " frames";
  EXPECT_GE(tree.age(), 1U);
}

}  // namespace
}  // namespace cbvh::golden
