// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/tree/validate.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "golden/build/lbvh.h"
#include "golden/quantize/scale.h"
#include "golden/scene/load.h"
#include "golden/scene/trouble_scenes.h"
#include "golden/tree/decode.h"
#include "golden/tree/sah.h"
#include "golden/update/top_down.h"

namespace cbvh::golden {
namespace {

GridRules auto_rules(const FloatTree& tree) {
  return {6, exactness_limit(tree.largest_magnitude), ScaleRule::equation2};
}

bool mentions(const std::vector<Violation>& violations, const std::string& what) {
  for (const Violation& v : violations) {
    if (to_string(v).find(what) != std::string::npos) return true;
  }
  return false;
}

TEST(Validate, an_upper_edge_one_cell_short_is_found_in_the_only_pair_that_has_it) {
  const FloatTree floats = build_lbvh(trouble_scene(Trouble::mixed_scales, 3, 40));
  const CompressedTree good = compress_top_down(floats, auto_rules(floats), Code::relative);
  ASSERT_TRUE(validate(good, floats).empty());
  int checks = 0;
  for (std::uint32_t i = 0; i < good.pairs.size(); ++i) {
    for (int c = 0; c < 2; ++c) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        if (!good.pairs[i].child[c].leaf) continue;
        CompressedTree shrunk = good;
        AxisCodes& codes = shrunk.pairs[i].child[c].codes[axis];
        if ((codes.upper + 63) % 64 == codes.lower) continue;  // one cell: nothing would be left
        codes.upper = static_cast<std::uint8_t>((codes.upper + 63) % 64);
        const std::vector<Violation> found = validate(shrunk, floats);
        // l = floor(q) + 1 leaves a whole cell unused when q lies on a cell edge: then the smaller box still encloses.
        if (found.empty()) continue;
        ASSERT_EQ(found.size(), 1U);
        ASSERT_EQ(found[0].index, i);
        ASSERT_EQ(found[0].child, c);
        ASSERT_NE(found[0].what.find("does not enclose"), std::string::npos);
        ++checks;
      }
    }
  }
  EXPECT_GT(checks, 20);
}

TEST(Validate, a_float_box_moved_by_one_ulp_out_of_its_cells_is_found_above_and_below_the_exactness_limit) {
  FloatTree floats = build_lbvh(trouble_scene(Trouble::axis_aligned, 9, 40));
  ASSERT_FALSE(floats.pairs.empty());
  for (const int min_scale : {auto_rules(floats).min_scale, -149}) {
    const CompressedTree tree = compress_top_down(floats, {6, min_scale, ScaleRule::equation2}, Code::modulo);
    const std::vector<std::array<Box, 2>> boxes = decode_boxes(tree);
    FloatTree moved = floats;
    ASSERT_TRUE(validate(tree, moved).empty());
    moved.pairs[0].child[1].upper.y = std::nextafter(boxes[0][1].upper.y, INFINITY);
    moved.pairs[0].child[0].lower.z = std::nextafter(boxes[0][0].lower.z, -INFINITY);
    const std::vector<Violation> found = validate(tree, moved);
    EXPECT_EQ(found.size(), 2U);
    EXPECT_TRUE(mentions(found, "pair 0, child 0: axis z"));
    EXPECT_TRUE(mentions(found, "pair 0, child 1: axis y"));
  }
}

TEST(Validate, counts_rules_and_wide_codes_are_checked) {
  const FloatTree floats = build_lbvh(trouble_scene(Trouble::lattice, 1, 40));
  const CompressedTree good =
      compress_top_down(floats, {4, auto_rules(floats).min_scale, ScaleRule::equation2}, Code::modulo);
  ASSERT_TRUE(validate(good).empty());
  CompressedTree bad = good;
  bad.rules.bits = 1;
  EXPECT_TRUE(mentions(validate(bad), "bits"));
  bad = good;
  ++bad.leaves;
  EXPECT_TRUE(mentions(validate(bad), "leaves for"));
  bad = good;
  bad.primitive_ids.pop_back();
  EXPECT_TRUE(mentions(validate(bad), "primitive IDs for"));
  bad = good;
  bad.pairs.back().child[0].codes[0].lower = static_cast<std::uint8_t>(bad.pairs.back().child[0].codes[0].lower + 16);
  EXPECT_TRUE(mentions(validate(bad), "want 4 bits"));
  bad = good;
  bad.primitive_ids.back() &= ~kLastOfLeaf;
  EXPECT_TRUE(mentions(validate(bad), "runs past"));
  bad = good;
  bad.root[1].lower += 1;
  EXPECT_TRUE(mentions(validate(bad), "root's grid"));
}

TEST(Validate, leaves_may_share_a_primitive_but_none_is_missing_or_twice_in_a_leaf) {
  const FloatTree floats = build_lbvh(trouble_scene(Trouble::lattice, 1, 40));
  CompressedTree shared = compress_top_down(floats, auto_rules(floats), Code::modulo);
  const std::uint32_t first = shared.primitive_ids[0] & ~kLastOfLeaf;
  shared.primitive_ids.back() &= ~kLastOfLeaf;
  shared.primitive_ids.push_back(first | kLastOfLeaf);
  EXPECT_TRUE(validate(shared).empty());
  CompressedTree twice = shared;
  *(twice.primitive_ids.end() - 2) = first;
  EXPECT_TRUE(mentions(validate(twice), fmt::format("primitive {} a second time", first)));
  CompressedTree missing = shared;
  const std::uint32_t last = missing.primitives;
  ++missing.primitives;
  missing.primitive_ids.insert(missing.primitive_ids.end() - 1, (first + 1) % last);
  EXPECT_TRUE(mentions(validate(missing), fmt::format("primitive {} is in no leaf", last)));
}

TEST(Validate, no_more_violations_than_asked_for) {
  const FloatTree floats = build_lbvh(load_scene("proc:cloth"));
  CompressedTree bad = compress_top_down(floats, auto_rules(floats), Code::modulo);
  for (CompressedPair& pair : bad.pairs) pair.child[0].codes[0].upper = pair.child[0].codes[0].lower;
  EXPECT_EQ(validate(bad, 7).size(), 7U);
}

TEST(Decode, boxes_enclose_the_float_boxes_and_nest) {
  std::size_t checks = 0;
  for (std::uint64_t id = 0; id < 240; ++id) {
    const FloatTree floats = build_lbvh(trouble_scene(kTroubles[id % kTroubles.size()], id));
    for (const int min_scale : {auto_rules(floats).min_scale, -149}) {
      const CompressedTree tree = compress_top_down(floats, {3, min_scale, ScaleRule::equation2}, Code::modulo);
      const std::vector<std::array<Box, 2>> boxes = decode_boxes(tree);
      for (std::size_t i = 0; i < boxes.size(); ++i) {
        for (std::size_t c = 0; c < 2; ++c) {
          const Box& box = boxes[i][c];
          const CompressedChild& child = tree.pairs[i].child[c];
          for (int axis = 0; axis < 3; ++axis) {
            ASSERT_LE(box.lower[axis], floats.pairs[i].child[c].lower[axis]);
            ASSERT_GE(box.upper[axis], floats.pairs[i].child[c].upper[axis]);
            for (std::size_t k = 0; k < 2 && !child.leaf; ++k) {
              ASSERT_LE(box.lower[axis], boxes[child.pointer][k].lower[axis]);
              ASSERT_GE(box.upper[axis], boxes[child.pointer][k].upper[axis]);
            }
            ++checks;
          }
        }
      }
    }
  }
  EXPECT_GT(checks, 10'000U);
}

TEST(Decode, both_codes_convert_into_each_other) {
  const FloatTree floats = build_lbvh(load_scene("proc:cloth"));
  const CompressedTree modulo = compress_top_down(floats, auto_rules(floats), Code::modulo);
  const CompressedTree relative = compress_top_down(floats, auto_rules(floats), Code::relative);
  EXPECT_FALSE(modulo.pairs == relative.pairs);
  EXPECT_TRUE(to_code(modulo, Code::relative).pairs == relative.pairs);
  EXPECT_TRUE(to_code(relative, Code::modulo).pairs == modulo.pairs);
}

TEST(Sah, of_a_tree_of_two_squares_is_computed_by_hand) {
  // Two flat boxes of half area 1 in a scene of 2 x 1 x 1, half area 5: 1 + (1 + 1) / 5.
  const Mesh mesh{"two", {{0, 0, 0}, {0, 1, 0}, {0, 0, 1}, {2, 0, 0}, {2, 1, 0}, {2, 0, 1}}, {{0, 1, 2}, {3, 4, 5}}};
  const FloatTree floats = build_lbvh(mesh);
  ASSERT_EQ(floats.pairs.size(), 1U);
  EXPECT_DOUBLE_EQ(sah(floats), 1 + 2.0 / 5);
  EXPECT_DOUBLE_EQ(sah(floats, {3, 5}), 3 + 5 * 2.0 / 5);
  // e_min 0: cells of 1; the squares become 1 x 2 x 2 (half area 8), from 0..1 and 2..3.
  const CompressedTree tree = compress_top_down(floats, {6, 0, ScaleRule::equation2}, Code::modulo);
  EXPECT_DOUBLE_EQ(sah(tree), 1 + 16.0 / 5);
}

TEST(Sah, a_scene_that_is_one_leaf_costs_its_primitives) {
  const FloatTree floats = build_lbvh({"one", {{1, 2, 3}}, {{0, 0, 0}, {0, 0, 0}}});
  EXPECT_DOUBLE_EQ(sah(floats), 2);
  EXPECT_DOUBLE_EQ(sah(compress_top_down(floats, auto_rules(floats), Code::modulo)), 2);
}

}  // namespace
}  // namespace cbvh::golden
