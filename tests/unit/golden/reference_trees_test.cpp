// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// The reference table of DESIGN 3.2. proc:cloth needs no file; the other rows need the folder named by CBVH_SCENES.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <ostream>

#include "golden/build/lbvh.h"
#include "golden/quantize/scale.h"
#include "golden/scene/load.h"
#include "golden/tree/digest.h"
#include "golden/tree/sah.h"
#include "golden/tree/validate.h"
#include "golden/update/streaming.h"
#include "golden/update/top_down.h"

namespace cbvh::golden {
namespace {

using Counts = std::array<std::uint64_t, 4>;  ///< backtracks for D = 1..4

struct RuleRow {
  std::uint64_t digest;
  Counts relative;
  Counts modulo;
};

struct SceneRow {
  const char* scene;
  std::size_t triangles;
  std::uint32_t leaves;
  int min_scale;
  std::array<int, 3> root;
  RuleRow equation2;
  RuleRow figure5;
};

const SceneRow kRows[] = {
    {"bunny",
     69451,
     65835,
     -26,
     {-8, -8, -9},
     {0xe951751189b99a47, {37688, 1404, 245, 40}, {1972, 371, 54, 6}},
     {0x1f7529795fefa85a, {40461, 3442, 650, 101}, {5554, 1214, 163, 20}}},
    {"armadillo",
     30000,
     29873,
     -23,
     {-4, -4, -4},
     {0xc856e2c3d71050ec, {15473, 856, 200, 31}, {1235, 292, 57, 7}},
     {0xefe814b87e564390, {17657, 2529, 665, 118}, {3813, 989, 188, 13}}},
    {"sponza",
     33663,
     26469,
     -13,
     {6, 5, 5},
     {0xaf6b0475f761c2ee, {15966, 1778, 374, 68}, {3334, 651, 87, 32}},
     {0x2ca45f7bb1b58922, {19565, 4810, 1925, 900}, {7519, 2756, 1144, 614}}},
    {"dragon",
     871414,
     756091,
     -26,
     {-8, -8, -9},
     {0x22ae565129b64d07, {403031, 15578, 4066, 709}, {26124, 5247, 1046, 118}},
     {0xa798b40476589e92, {434489, 40038, 10291, 2011}, {68072, 15705, 3377, 405}}},
    {"proc:cloth",
     65000,
     36722,
     -23,
     {-4, -4, -6},
     {0x8bd6f10416322ba7, {19275, 156, 38, 0}, {228, 22, 0, 0}},
     {0xa5e5eebd9bf15fb1, {20814, 1493, 745, 114}, {1262, 594, 80, 24}}},
};

/// The scene's path; empty when it is a file that is not there.
std::string path_of(const std::string& scene) {
  if (scene.starts_with("proc:")) return scene;
  const char* folder = std::getenv("CBVH_SCENES");
  if (folder == nullptr) return {};
  const std::filesystem::path path = std::filesystem::path(folder) / (scene + ".glb");
  return std::filesystem::exists(path) ? path.string() : std::string();
}

std::ostream& operator<<(std::ostream& out, const SceneRow& row) { return out << row.scene; }

class ReferenceTrees : public testing::TestWithParam<SceneRow> {
 protected:
  void check(const FloatTree& tree, ScaleRule scale_rule, const RuleRow& row) {
    const GridRules rules{6, exactness_limit(tree.largest_magnitude), scale_rule};
    for (const Code code : {Code::relative, Code::modulo}) {
      const CompressedTree top_down = compress_top_down(tree, rules, code);
      EXPECT_EQ(digest(top_down), row.digest);
      const std::vector<Violation> violations = validate(top_down, tree);
      ASSERT_TRUE(violations.empty()) << to_string(violations.front());
      StreamingCounts all;
      for (int levels = 1; levels <= 4; ++levels) {
        SCOPED_TRACE(fmt::format("relative {} D {}", code == Code::relative, levels));
        const StreamingResult streamed = compress_streaming(tree, rules, code, levels);
        EXPECT_TRUE(streamed.tree.pairs == top_down.pairs);
        const auto column = static_cast<std::size_t>(levels - 1);
        EXPECT_EQ(streamed.counts.backtracks, (code == Code::relative ? row.relative : row.modulo)[column]);
        if (levels == 1) all = streamed.counts;
        std::uint64_t tail = 0;
        for (std::size_t d = column + 1; d < all.depth_histogram.size(); ++d) tail += all.depth_histogram[d];
        EXPECT_EQ(streamed.counts.backtracks, tail) << "the D = 1 iterations at depth >= D";
        ++checks;
      }
    }
  }

  int checks = 0;
};

TEST_P(ReferenceTrees, digest_counts_and_identity_are_the_tabulated_ones) {
  const SceneRow& row = GetParam();
  const std::string path = path_of(row.scene);
  if (path.empty()) GTEST_SKIP() << "CBVH_SCENES has no " << row.scene;
  const Mesh mesh = load_scene(path);
  EXPECT_EQ(mesh.triangles.size(), row.triangles);
  const FloatTree tree = build_lbvh(mesh);
  EXPECT_EQ(tree.primitives, row.triangles);
  EXPECT_EQ(tree.leaves, row.leaves);
  EXPECT_EQ(tree.pairs.size(), row.leaves - 1);
  EXPECT_EQ(exactness_limit(tree.largest_magnitude), row.min_scale);
  const Context<std::int64_t> root = root_context<std::int64_t>(tree.scene, {6, row.min_scale, ScaleRule::equation2});
  for (std::size_t axis = 0; axis < 3; ++axis) EXPECT_EQ(root[axis].scale, row.root[axis]);
  check(tree, ScaleRule::equation2, row.equation2);
  check(tree, ScaleRule::figure5, row.figure5);
  EXPECT_EQ(checks, 2 * 2 * 4);
}

INSTANTIATE_TEST_SUITE_P(Table, ReferenceTrees, testing::ValuesIn(kRows), [](const auto& row) {
  const std::string scene = row.param.scene;
  return scene.substr(scene.find(':') + 1);
});

TEST(MinimumScale, cloth_backtracks_and_quality_over_the_tabulated_scales) {
  struct Row {
    int min_scale;
    std::uint64_t one_level;
    std::uint64_t four_levels;
    double quality;  ///< SAH against the best
    double half_digit;
  };
  const Row rows[] = {{-126, 22712, 22468, 1, 5e-5}, {-60, 1236, 992, 1, 5e-5},   {-30, 244, 0, 1, 5e-5},
                      {-20, 228, 0, 1, 5e-5},        {-15, 212, 0, 1.0005, 5e-5}, {-10, 48, 0, 1.033, 5e-4},
                      {-5, 0, 0, 4.67, 5e-3}};
  const FloatTree tree = build_lbvh(load_scene("proc:cloth"));
  double best = 0;
  int checks = 0;
  for (const Row& row : rows) {
    const GridRules rules{6, row.min_scale, ScaleRule::equation2};
    const StreamingResult one = compress_streaming(tree, rules, Code::modulo, 1);
    EXPECT_EQ(one.counts.backtracks, row.one_level) << row.min_scale;
    EXPECT_EQ(compress_streaming(tree, rules, Code::modulo, 4).counts.backtracks, row.four_levels) << row.min_scale;
    EXPECT_TRUE(one.tree.pairs == compress_top_down(tree, rules, Code::modulo).pairs);
    EXPECT_TRUE(validate(one.tree, tree).empty());
    const double quality = sah(one.tree);
    if (best == 0) best = quality;
    EXPECT_NEAR(quality / best, row.quality, row.half_digit) << row.min_scale;
    ++checks;
  }
  EXPECT_EQ(checks, 7);
}

TEST(Units, a_scene_scaled_by_a_power_of_two_has_the_same_codes) {
  Mesh mesh = load_scene("proc:cloth");
  const FloatTree tree = build_lbvh(mesh);
  const GridRules rules{6, exactness_limit(tree.largest_magnitude), ScaleRule::equation2};
  const CompressedTree wanted = compress_top_down(tree, rules, Code::modulo);
  for (const int j : {-90, -1, 40}) {
    Mesh scaled = mesh;
    for (glm::vec3& p : scaled.positions) p *= static_cast<float>(power_of_two(j));
    const FloatTree scaled_tree = build_lbvh(scaled);
    const GridRules scaled_rules{6, exactness_limit(scaled_tree.largest_magnitude), ScaleRule::equation2};
    EXPECT_EQ(scaled_rules.min_scale, rules.min_scale + j);
    const CompressedTree found = compress_top_down(scaled_tree, scaled_rules, Code::modulo);
    EXPECT_TRUE(found.pairs == wanted.pairs);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      EXPECT_EQ(found.root[axis].scale, wanted.root[axis].scale + j);
      EXPECT_EQ(found.root[axis].lower, wanted.root[axis].lower);
    }
  }
}

}  // namespace
}  // namespace cbvh::golden
