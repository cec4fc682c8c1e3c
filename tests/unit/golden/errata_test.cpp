// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// What is wrong in the paper's text: each test puts the literal form beside ours and shows where it breaks.
// docs/arithmetic.md lists them.
#include <gtest/gtest.h>

#include "golden/build/lbvh.h"
#include "golden/quantize/quantize.h"
#include "golden/scene/load.h"
#include "golden/scene/trouble_scenes.h"
#include "golden/tree/pair_codec.h"
#include "golden/update/streaming.h"
#include "tests/unit/golden/random_floats.h"

namespace cbvh::golden {
namespace {

using test::Random;
using Narrow = Cells<std::int64_t>;

TEST(Errata, equation9_condition_is_s_equals_zero_not_r_equals_s) {
  const auto decode_as_printed = [](AxisCodes codes, std::int64_t parent) {
    const std::int64_t r = modulo(codes.lower - parent, 6);
    const std::int64_t s = modulo(codes.upper - parent, 6);
    return Narrow{parent + r, parent + (codes.lower != codes.upper ? s : s + 64)};
  };
  int wrong = 0;
  for (std::int64_t r = 0; r < 64; ++r) {
    const Narrow cells{100 + r, 100 + 64};  // s = 2^N
    const AxisCodes codes = encode_codes(cells, std::int64_t{100}, Code::modulo, 6);
    ASSERT_EQ(decode_codes(codes, std::int64_t{100}, Code::modulo, 6), cells);
    wrong += decode_as_printed(codes, 100) != cells;
  }
  EXPECT_EQ(wrong, 63);  // every r > 0
}

TEST(Errata, figure5_loop_stops_one_step_coarser_when_the_size_is_a_power_of_two) {
  const auto loop_as_printed = [](int gridsize, int scale) {
    while (gridsize < (1 << 5)) {
      gridsize <<= 1;
      --scale;
    }
    return scale;
  };
  for (int cells = 1; cells <= 63; ++cells) {
    const bool power_of_two_size = (cells & (cells - 1)) == 0;
    ASSERT_EQ(loop_as_printed(cells, 0), own_scale(cells, 0, GridRules{}) + (power_of_two_size ? 1 : 0)) << cells;
    ASSERT_EQ(loop_as_printed(cells, 0), own_scale(cells, 0, GridRules{6, -149, ScaleRule::figure5})) << cells;
  }
}

TEST(Errata, alignment_rounds_negative_numbers_towards_minus_infinity_not_to_zero) {
  const float lower = -1.5F;
  const auto truncated = static_cast<std::int64_t>(lower);  // sign-magnitude alignment that drops bits
  EXPECT_GT(static_cast<float>(truncated), lower);          // does not enclose
  EXPECT_LE(edge(floor_on_grid<std::int64_t>(lower, 0), 0), lower);
}

TEST(Errata, the_sign_must_be_tested_as_set_since_below_zero_is_never_true) {
  const int lb_m = -3;
  const int lb_s = lb_m < 0 ? 1 : 0;
  const int as_printed = lb_s < 0 ? -lb_m : lb_m;  // "if (lb_s < 0) lb_m = -lb_m"
  EXPECT_LT(as_printed, 0) << "pack_float would get a negative magnitude";
  EXPECT_EQ(edge<std::int64_t>(lb_m, 0), -3.0F);
}

TEST(Errata, the_decoded_upper_bound_comes_from_the_upper_mantissa) {
  const Narrow cells = encode<std::int64_t>(1.0F, 7.5F, 0);
  const float as_printed = edge(cells.lower, 0);  // "cub_out = pack_float(lb_m, ...)"
  EXPECT_LT(as_printed, 7.5F) << "does not enclose";
  EXPECT_EQ(edge(cells.upper, 0), 8.0F);
}

TEST(Errata, backtracking_takes_the_ceiling_since_floor_plus_one_grows_and_overflows_relative_codes) {
  const std::int64_t parent = -128;
  const Narrow full{parent, parent + 64};
  const Narrow coarse = coarsen(full, 1);
  const Narrow literal{floor_divide(full.lower, 1), floor_divide(full.upper, 1) + 1};
  EXPECT_EQ(coarse, (Narrow{-64, -32}));
  EXPECT_EQ(literal.upper, coarse.upper + 1) << "grew by a cell";
  // On a grid that stays (d = 0) the literal form leaves the N bits of a relative code.
  const Narrow grown{full.lower, floor_divide(full.upper, 0) + 1};
  EXPECT_NE(decode_codes(encode_codes(grown, parent, Code::relative, 6), parent, Code::relative, 6), grown);
  EXPECT_EQ(coarsen(full, 0), full);
}

/// The exponent of q - p alone, as section 4.1 estimates: 2^e' >= q - p cut into 2^N cells.
int literal_estimate(float lower, float upper, bool rounded, int bits) {
  const double exact = static_cast<double>(upper) - static_cast<double>(lower);
  const double width = rounded ? static_cast<double>(upper - lower) : exact;
  return floor_log2(width) + 1 - bits;
}

TEST(Errata, the_exponent_of_the_difference_alone_can_need_one_cell_too_many) {
  Random random{5};
  int too_fine = 0;
  const int cases = 100'000;
  for (int i = 0; i < cases; ++i) {
    const float p = static_cast<float>(random.between(-1'000'000, 1'000'000)) * 0x1p-20F;
    const float q = p + static_cast<float>(random.between(1, 65'536)) * 0x1p-20F;
    const int e = literal_estimate(p, q, false, 6);
    const Narrow cells = encode<std::int64_t>(p, q, e);
    too_fine += cells.upper - cells.lower > 64;
    const int ours = enclosing_scale(p, q, GridRules{});
    const Narrow enclosing = encode<std::int64_t>(p, q, ours);
    ASSERT_LE(enclosing.upper - enclosing.lower, 64);
  }
  EXPECT_GT(too_fine, 0);
  EXPECT_LT(too_fine, cases / 20);
}

TEST(Errata, a_difference_rounded_to_nearest_can_exceed_the_true_scale) {
  const float lower = -0x1p23F;
  const float upper = 0x1p23F - 0.5F;
  ASSERT_EQ(upper - lower, 0x1p24F) << "the difference, 2^24 - 0.5, rounds up to a power of two";
  EXPECT_EQ(enclosing_scale(lower, upper, GridRules{}), 18);
  EXPECT_EQ(literal_estimate(lower, upper, false, 6), 18);
  EXPECT_EQ(literal_estimate(lower, upper, true, 6), 19) << "coarser than the truth: repairs only ever coarsen";
}

TEST(Errata, scale_only_comparison_is_not_enough_for_relative_codes) {
  const FloatTree tree = build_lbvh(load_scene("proc:cloth"));
  const GridRules rules{6, exactness_limit(tree.largest_magnitude), ScaleRule::equation2};
  std::uint64_t same_scales = 0;
  std::uint64_t wrong_if_left = 0;
  StreamingObserver observer;
  observer.on_repair = [&](std::uint32_t, const CompressedPair& old_pair, const CompressedPair&,
                           const Context<std::int64_t>& from, const Context<std::int64_t>& to) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (from[axis].scale != to[axis].scale) return;  // algorithm 1 as printed repairs these, and only these
    }
    ++same_scales;
    wrong_if_left += decode_codes(old_pair, to, Code::relative, 6) != decode_codes(old_pair, from, Code::relative, 6);
  };
  compress_streaming(tree, rules, Code::relative, 1, &observer);
  EXPECT_GT(same_scales, 1000U);
  EXPECT_EQ(wrong_if_left, same_scales) << "left as it was, every such pair would decode to other cells";
}

TEST(Errata, contexts_are_popped_for_inner_children_not_for_leaves) {
  const FloatTree tree = build_lbvh(trouble_scene(Trouble::mixed_scales, 3, 40));
  ASSERT_GT(tree.pairs.size(), 8U);
  const auto run = [&](bool pops_for) {  // the leaf bit that pops; false when the stack is empty or the wrong child's
                                         // context is on top
    std::vector<std::uint32_t> stack;
    for (std::uint32_t i = 0; i < tree.pairs.size(); ++i) {
      for (const int child : {1, 0}) {
        if (tree.pairs[i].leaf[child] != pops_for) continue;
        if (stack.empty() || stack.back() != tree.pairs[i].pointer[child]) return false;
        stack.pop_back();
      }
      stack.push_back(i);
    }
    return stack.size() == 1;
  };
  EXPECT_FALSE(run(true)) << "as printed: if child is a leaf then pop";
  EXPECT_TRUE(run(false));
}

TEST(Errata, each_child_is_encoded_from_its_own_box) {
  // "Encode(bvhNode.aabbs[0], oldChildContexts[1].aabbs[1], context)": nothing of that name exists there; child 1's own
  // box is meant.
  const FloatTree tree = build_lbvh(trouble_scene(Trouble::mixed_scales, 3, 40));
  int outside = 0;
  for (const FloatPair& pair : tree.pairs) {
    const Context<std::int64_t> context =
        root_context<std::int64_t>(own_box(pair), {6, exactness_limit(tree.largest_magnitude), ScaleRule::equation2});
    const PairCells<std::int64_t> cells = encode_cells(pair, context);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto i = static_cast<int>(axis);
      const Cells<std::int64_t> own =
          encode<std::int64_t>(pair.child[1].lower[i], pair.child[1].upper[i], context[axis].scale);
      EXPECT_EQ(cells[1][axis], own);
      outside += cells[0][axis].lower > own.lower || cells[0][axis].upper < own.upper;
    }
  }
  EXPECT_GT(outside, 0) << "any other box would not enclose";
}

TEST(Errata, a_treelet_of_m_levels_has_two_to_the_m_minus_one_pairs_not_m_squared_minus_one) {
  Mesh mesh{"64 points on a line", {}, {}};
  for (std::uint32_t i = 0; i < 64; ++i) {
    mesh.positions.emplace_back(static_cast<float>(i), 0.0F, 0.0F);
    mesh.triangles.emplace_back(i, i, i);
  }
  const FloatTree tree = build_lbvh(mesh);  // a complete tree
  const auto root = static_cast<std::uint32_t>(tree.pairs.size() - 1);
  for (int levels = 1; levels <= 5; ++levels) {
    // The root's treelet of D levels is final but for the pairs that the last flush writes: those of D - 1 levels.
    std::size_t flushed = 0;
    StreamingObserver observer;
    observer.on_final = [&](std::uint32_t index, const CompressedPair&, const Context<std::int64_t>&) {
      flushed += index == root || flushed > 0;
    };
    compress_streaming(tree, {6, -17, ScaleRule::equation2}, Code::modulo, levels + 1, &observer);
    EXPECT_EQ(flushed, (std::size_t{1} << levels) - 1);
    if (levels == 3) {
      EXPECT_NE(flushed, 3U * 3U - 1U) << "as printed";
    }
  }
}

TEST(Errata, table_1_gives_the_abstracts_savings_not_the_conclusions) {
  const int lbvh_percent_left = 58;  // modulo, treelet depth 4, average
  const int refit_percent_left = 44;
  EXPECT_EQ(100 - lbvh_percent_left, 42);
  EXPECT_EQ(100 - refit_percent_left, 56);
  EXPECT_NE(100 - lbvh_percent_left, 38);
  EXPECT_NE(100 - refit_percent_left, 54);
}

TEST(Errata, edges_finer_than_a_floats_last_place_are_no_floats) {
  const float plane = -0.4F;  // the cloth's
  const int limit = exactness_limit(plane);
  const Cells<Wide> fine = encode<Wide>(plane, plane, limit - 10);
  EXPECT_EQ(edge(fine.lower, limit - 10), plane);
  EXPECT_THROW(edge(fine.upper, limit - 10), std::logic_error) << "the next cell edge lies between two floats";
  EXPECT_EQ(edge_up(fine.upper, limit - 10), std::nextafter(plane, 0.0F));
  const Cells<std::int64_t> exact = encode<std::int64_t>(plane, plane, limit);
  EXPECT_EQ(edge(exact.upper, limit), std::nextafter(plane, 0.0F));
}

}  // namespace
}  // namespace cbvh::golden
