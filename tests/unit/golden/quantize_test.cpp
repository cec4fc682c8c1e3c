// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/quantize/quantize.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "golden/input_error.h"
#include "tests/unit/golden/random_floats.h"

namespace cbvh::golden {
namespace {

using test::floor_of;
using test::Integer;
using test::Random;
using test::Rational;
using test::two_to;

constexpr float kInfinity = std::numeric_limits<float>::infinity();

TEST(Quantize, encode_is_the_floor_of_the_exact_quotient_on_every_grid) {
  Random random{1};
  int checks = 0;
  for (int i = 0; i < 4000; ++i) {
    float p = random.any_float();
    float q = random.any_float();
    if (p > q) std::swap(p, q);
    const int scale = random.between(-149, 127);
    const Integer k = floor_of(Rational{p} / two_to(scale));
    const Integer l = floor_of(Rational{q} / two_to(scale)) + 1;
    const Cells<Wide> wide = encode<Wide>(p, q, scale);
    ASSERT_EQ(wide.lower.str(), k.str()) << p << " on 2^" << scale;
    ASSERT_EQ(wide.upper.str(), l.str()) << q << " on 2^" << scale;
    ++checks;
    const int exact = std::max(exactness_limit(std::max(std::abs(p), std::abs(q))), scale);
    const Cells<std::int64_t> narrow = encode<std::int64_t>(p, q, exact);
    ASSERT_EQ(Integer{narrow.lower}, floor_of(Rational{p} / two_to(exact)));
    ASSERT_EQ(Integer{narrow.upper}, floor_of(Rational{q} / two_to(exact)) + 1);
    ASSERT_LE(std::abs(narrow.lower), 1 << 24);
    ASSERT_LE(std::abs(narrow.upper), 1 << 24);
    ASSERT_EQ(Rational{edge(narrow.lower, exact)}, Rational{narrow.lower} * two_to(exact));
  }
  EXPECT_EQ(checks, 4000);
}

TEST(Quantize, negative_zero_counts_as_zero) {
  EXPECT_EQ(encode<std::int64_t>(-0.0F, -0.0F, -149), (Cells<std::int64_t>{0, 1}));
  EXPECT_FALSE(std::signbit(edge<std::int64_t>(0, -149)));
  EXPECT_FALSE(std::signbit(edge_up(std::int64_t{0}, -149)));
}

template <class Index>
void check_divisions() {
  for (int d = 0; d < 70; ++d) {
    for (int n = -300; n <= 300; ++n) {
      const Rational quotient = Rational{n} / two_to(d);
      ASSERT_EQ(static_cast<std::int64_t>(floor_divide(Index{n}, d)), static_cast<std::int64_t>(floor_of(quotient)));
      ASSERT_EQ(static_cast<std::int64_t>(ceil_divide(Index{n}, d)), -static_cast<std::int64_t>(floor_of(-quotient)));
    }
  }
  for (int bits = 2; bits <= 8; ++bits) {
    for (int n = -600; n <= 600; ++n) {
      const auto m = modulo(Index{n}, bits);
      ASSERT_GE(m, 0);
      ASSERT_LT(m, 1 << bits);
      ASSERT_EQ((m - n) % (1 << bits), 0);
    }
  }
}

TEST(Quantize, divisions_round_towards_minus_and_plus_infinity_for_negatives_too) {
  check_divisions<std::int64_t>();
  check_divisions<Wide>();
}

TEST(Quantize, exactness_limit_is_the_finest_grid_whose_indices_fit_24_bits) {
  EXPECT_EQ(exactness_limit(0.0F), -149);
  EXPECT_EQ(exactness_limit(1.0F), -23);
  EXPECT_EQ(exactness_limit(std::nextafter(1.0F, 0.0F)), -24);
  EXPECT_EQ(exactness_limit(0x1p-149F), -149);
  EXPECT_EQ(exactness_limit(0x1p-126F), -149);
  EXPECT_EQ(exactness_limit(0x1p-125F), -148);
  EXPECT_EQ(exactness_limit(std::numeric_limits<float>::max()), 104);
}

TEST(Quantize, edge_of_2_to_the_128_is_infinity_and_inexact_edges_round_outwards) {
  EXPECT_EQ(edge<std::int64_t>(1 << 24, 104), kInfinity);
  EXPECT_EQ(edge<std::int64_t>(-(1 << 24), 104), -kInfinity);
  EXPECT_EQ(edge<std::int64_t>((1 << 24) - 1, 104), std::numeric_limits<float>::max());
  EXPECT_EQ(edge<Wide>(Wide{1} << 277, -149), kInfinity);
  EXPECT_EQ(edge_down(Wide{(Wide{1} << 277) - 1}, -149), std::numeric_limits<float>::max());
  EXPECT_EQ(edge_up(Wide{(Wide{1} << 277) - 1}, -149), kInfinity);
  EXPECT_THROW(edge<std::int64_t>((1 << 24) + 1, 0), std::logic_error);
  EXPECT_THROW(edge<std::int64_t>((std::int64_t{1} << 62) + 1, 0), std::logic_error);
  Random random{2};
  for (int i = 0; i < 4000; ++i) {
    const Wide index = floor_on_grid<Wide>(random.any_float(), random.between(-149, 100)) + random.between(-9, 9);
    const int scale = random.between(-149, -60);
    if (abs(index) > (Wide{1} << static_cast<unsigned>(127 - scale))) continue;
    const Rational value = Rational{Integer{index}} * two_to(scale);
    const float down = edge_down(index, scale);
    const float up = edge_up(index, scale);
    ASSERT_LE(Rational{down}, value);
    ASSERT_GE(Rational{up}, value);
    if (down == up) {
      ASSERT_EQ(Rational{down}, value);
      ASSERT_EQ(edge(index, scale), down);
    } else {
      ASSERT_EQ(std::nextafter(down, kInfinity), up);
    }
    if (abs(index) < (Wide{1} << 62)) {
      const auto narrow = static_cast<std::int64_t>(index);
      ASSERT_EQ(edge_down(narrow, scale), down);
      ASSERT_EQ(edge_up(narrow, scale), up);
    }
  }
}

TEST(Quantize, own_scale_is_the_finest_that_equation_2_allows) {
  int checks = 0;
  for (const ScaleRule rule : {ScaleRule::equation2, ScaleRule::figure5}) {
    for (int bits = 2; bits <= 8; ++bits) {
      for (const int min_scale : {-149, -3, 5}) {
        const GridRules rules{bits, min_scale, rule};
        for (std::int64_t cells = 1; cells <= rules.max_cells(); ++cells) {
          int wanted = 5;
          for (int s = 0; s <= bits; ++s) {
            if (cells << s <= rules.max_cells()) wanted = std::max(5 - s, min_scale);
          }
          ASSERT_EQ(own_scale(cells, 5, rules), wanted) << bits << ' ' << cells;
          ASSERT_EQ(own_scale(Wide{cells}, 5, rules), wanted);
          ++checks;
        }
      }
    }
  }
  EXPECT_EQ(checks, 3 * (2 * 508 - 7));
}

TEST(Quantize, enclosing_scale_is_the_smallest_at_or_above_the_minimum_that_fits) {
  Random random{3};
  for (int i = 0; i < 3000; ++i) {
    float p = random.any_float();
    float q = random.any_float();
    if (i % 3 == 0)
      q = std::bit_cast<float>(std::bit_cast<std::uint32_t>(p) ^ static_cast<std::uint32_t>(random.bits() % 4096));
    if (i % 7 == 0) q = p;
    if (!std::isfinite(q)) continue;
    if (p > q) std::swap(p, q);
    const GridRules rules{random.between(2, 8), random.between(-149, 127),
                          i % 2 == 0 ? ScaleRule::equation2 : ScaleRule::figure5};
    int wanted = rules.min_scale;
    while (floor_of(Rational{q} / two_to(wanted)) + 1 - floor_of(Rational{p} / two_to(wanted)) > rules.max_cells())
      ++wanted;
    ASSERT_EQ(enclosing_scale(p, q, rules), wanted) << p << ' ' << q << " e_min " << rules.min_scale;
  }
}

TEST(Quantize, coarsening_equals_encoding_on_the_coarser_grid) {
  Random random{4};
  for (int i = 0; i < 4000; ++i) {
    float p = random.any_float();
    float q = random.any_float();
    if (p > q) std::swap(p, q);
    const int fine = random.between(-149, 127);
    const int coarse = random.between(fine, 127);
    ASSERT_EQ(coarsen(encode<Wide>(p, q, fine), coarse - fine), encode<Wide>(p, q, coarse));
  }
}

TEST(Quantize, codes_decode_to_the_cells_they_encode_for_every_child_of_every_parent) {
  for (int bits = 2; bits <= 5; ++bits) {
    const std::int64_t span = std::int64_t{1} << bits;
    for (std::int64_t parent = -2 * span; parent <= 2 * span; ++parent) {
      for (std::int64_t r = 0; r < span; ++r) {
        for (std::int64_t s = r + 1; s <= span; ++s) {
          for (const Code code : {Code::modulo, Code::relative}) {
            const Cells<std::int64_t> cells{parent + r, parent + s};
            ASSERT_EQ(decode_codes(encode_codes(cells, parent, code, bits), parent, code, bits), cells);
            const Cells<Wide> wide{Wide{cells.lower}, Wide{cells.upper}};
            ASSERT_EQ(encode_codes(wide, Wide{parent}, code, bits), encode_codes(cells, parent, code, bits));
            ASSERT_EQ(decode_codes(encode_codes(wide, Wide{parent}, code, bits), Wide{parent}, code, bits), wide);
          }
        }
      }
    }
  }
}

TEST(Quantize, rules_outside_the_domain_are_refused_by_name) {
  EXPECT_NO_THROW(check_rules({}));
  EXPECT_THROW(check_rules({.bits = 1}), InputError);
  EXPECT_THROW(check_rules({.bits = 9}), InputError);
  EXPECT_THROW(check_rules({.min_scale = -150}), InputError);
  EXPECT_THROW(check_rules({.min_scale = 128}), InputError);
}

}  // namespace
}  // namespace cbvh::golden
