// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/build/lbvh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <limits>
#include <numeric>

#include "golden/build/morton.h"
#include "golden/input_error.h"
#include "golden/scene/trouble_scenes.h"

namespace cbvh::golden {
namespace {

/// DESIGN 3.2 once more, without any of build_lbvh's means: bit by bit, std::stable_sort, a scan for every split.
struct NaiveLbvh {
  struct Primitive {
    Box box;
    std::uint32_t code;
    std::uint32_t id;
  };
  struct Node {
    Box box;
    bool leaf;
    std::uint32_t pointer;
  };

  explicit NaiveLbvh(const Mesh& mesh) {
    for (std::uint32_t id = 0; id < mesh.triangles.size(); ++id) {
      Box box{glm::vec3(INFINITY), glm::vec3(-INFINITY)};
      for (int corner = 0; corner < 3; ++corner) {
        for (int axis = 0; axis < 3; ++axis) {
          const float x = mesh.positions[mesh.triangles[id][corner]][axis];
          box.lower[axis] = std::min(box.lower[axis], x);
          box.upper[axis] = std::max(box.upper[axis], x);
        }
      }
      primitives.push_back({box, 0, id});
    }
    Box scene = primitives[0].box;
    for (const Primitive& p : primitives)
      scene = {glm::min(scene.lower, p.box.lower), glm::max(scene.upper, p.box.upper)};
    for (Primitive& p : primitives) p.code = code(p.box, scene);
    std::stable_sort(primitives.begin(), primitives.end(), [](auto& a, auto& b) { return a.code < b.code; });
    build(0, primitives.size());
  }

  static std::uint32_t code(const Box& box, const Box& scene) {
    std::uint32_t result = 0;
    for (int bit = 9; bit >= 0; --bit) {
      for (int axis = 0; axis < 3; ++axis) {
        const float smin = scene.lower[axis];
        const float smax = scene.upper[axis];
        const float c = box.lower[axis] * 0.5F + box.upper[axis] * 0.5F;
        const float t = std::isfinite(smax - smin)
                            ? ((c - smin) / (smax - smin)) * 1024
                            : ((c * 0.25F - smin * 0.25F) / (smax * 0.25F - smin * 0.25F)) * 1024;
        const int q = !(smax - smin > 0) || !(t > 0) ? 0 : t >= 1023 ? 1023 : static_cast<int>(std::trunc(t));
        result = result * 2 + static_cast<std::uint32_t>(q >> bit & 1);
      }
    }
    return result;
  }

  Node build(std::size_t first, std::size_t last) {
    std::size_t middle = first;
    for (int bit = 29; bit >= 0 && middle == first; --bit) {
      for (std::size_t i = first + 1; i < last; ++i) {
        if ((primitives[i].code >> bit) != (primitives[i - 1].code >> bit)) middle = i;
      }
    }
    if (middle == first) {
      Node leaf{primitives[first].box, true, static_cast<std::uint32_t>(ids.size())};
      for (std::size_t i = first; i < last; ++i) {
        leaf.box = {glm::min(leaf.box.lower, primitives[i].box.lower),
                    glm::max(leaf.box.upper, primitives[i].box.upper)};
        ids.push_back(primitives[i].id);
      }
      ids.back() += 1U << 31;
      return leaf;
    }
    const Node a = build(first, middle);
    const Node b = build(middle, last);
    pairs.push_back({{a.box, b.box}, {a.leaf, b.leaf}, {a.pointer, b.pointer}});
    return {{glm::min(a.box.lower, b.box.lower), glm::max(a.box.upper, b.box.upper)},
            false,
            static_cast<std::uint32_t>(pairs.size() - 1)};
  }

  std::vector<Primitive> primitives;
  std::vector<FloatPair> pairs;
  std::vector<std::uint32_t> ids;
};

TEST(Lbvh, equals_the_naive_builder_on_every_kind_of_trouble) {
  std::size_t pairs = 0;
  for (std::uint64_t id = 0; id < 600; ++id) {
    const Mesh mesh = trouble_scene(kTroubles[id % kTroubles.size()], id, 200);
    const FloatTree tree = build_lbvh(mesh);
    const NaiveLbvh naive(mesh);
    ASSERT_EQ(tree.primitive_ids, naive.ids) << mesh.name;
    ASSERT_EQ(tree.pairs.size(), naive.pairs.size()) << mesh.name;
    ASSERT_EQ(tree.leaves, tree.pairs.size() + 1);
    ASSERT_EQ(tree.primitives, mesh.triangles.size());
    for (std::size_t i = 0; i < tree.pairs.size(); ++i) {
      for (int c = 0; c < 2; ++c) {
        ASSERT_EQ(tree.pairs[i].child[c].lower, naive.pairs[i].child[c].lower) << mesh.name;
        ASSERT_EQ(tree.pairs[i].child[c].upper, naive.pairs[i].child[c].upper) << mesh.name;
        ASSERT_EQ(tree.pairs[i].leaf[c], naive.pairs[i].leaf[c]) << mesh.name;
        ASSERT_EQ(tree.pairs[i].pointer[c], naive.pairs[i].pointer[c]) << mesh.name;
      }
    }
    pairs += tree.pairs.size();
  }
  EXPECT_GT(pairs, 10'000U);
}

TEST(Lbvh, an_extent_that_overflows_still_spreads_the_codes) {
  constexpr float kMax = std::numeric_limits<float>::max();
  EXPECT_EQ(morton_axis(-kMax, -kMax, -kMax, kMax), 0U);
  EXPECT_EQ(morton_axis(0, 0, -kMax, kMax), 512U);
  EXPECT_EQ(morton_axis(kMax, kMax, -kMax, kMax), 1023U);
  EXPECT_EQ(morton_axis(-kMax, kMax, -kMax, kMax), 512U) << "the centre of halves does not overflow";
}

TEST(Lbvh, equal_codes_are_one_leaf_in_input_order_and_one_leaf_has_no_pair) {
  Mesh mesh{"same", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}}};
  const FloatTree tree = build_lbvh(mesh);
  EXPECT_TRUE(tree.pairs.empty());
  EXPECT_EQ(tree.leaves, 1U);
  EXPECT_EQ(tree.primitive_ids, (std::vector<std::uint32_t>{0, 1, 2 | kLastOfLeaf}));
}

TEST(Lbvh, negative_zero_becomes_zero) {
  const FloatTree tree = build_lbvh({"zero", {{-0.0F, -0.0F, -0.0F}}, {{0, 0, 0}}});
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_FALSE(std::signbit(tree.scene.lower[axis]));
    EXPECT_FALSE(std::signbit(tree.scene.upper[axis]));
  }
}

TEST(Lbvh, invalid_input_is_refused_with_its_place) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const auto message = [](const Mesh& mesh) -> std::string {
    try {
      build_lbvh(mesh);
    } catch (const InputError& error) {
      return error.what();
    }
    return {};
  };
  EXPECT_NE(message({"m", {{0, 0, 0}, {0, nan, 0}}, {{0, 0, 1}}}).find("vertex 1"), std::string::npos);
  EXPECT_NE(message({"m", {{0, 0, 0}, {0, 0, INFINITY}}, {{0, 0, 1}}}).find("vertex 1"), std::string::npos);
  EXPECT_NE(message({"m", {{0, 0, 0}}, {{0, 0, 0}, {0, 1, 0}}}).find("triangle 1"), std::string::npos);
  EXPECT_NE(message({"m", {}, {}}).find("no triangles"), std::string::npos);
}

TEST(Lbvh, more_than_2_to_the_27_primitives_or_pairs_is_an_error_that_says_so) {
  EXPECT_NO_THROW(check_counts("m", kMaxCount, kMaxCount));
  EXPECT_THROW(check_counts("m", kMaxCount + 1, 0), InputError);
  EXPECT_THROW(check_counts("m", 0, kMaxCount + 1), InputError);
}

}  // namespace
}  // namespace cbvh::golden
