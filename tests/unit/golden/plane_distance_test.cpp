// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/trace/plane_distance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "tests/unit/golden/random_floats.h"

namespace cbvh::golden {
namespace {

using test::Random;
using test::Rational;

/// Values of one sort: comparisons are close when three of them are of the same one.
std::vector<float> values(Random& random, int sort) {
  std::vector<float> result;
  const auto mantissa = [&] { return static_cast<float>(random.between(1, 0xFFFFFF)); };
  for (int i = 0; i < 3; ++i) {
    const float sign = random.between(0, 1) == 0 ? 1.0F : -1.0F;
    const int exponent = sort == 0   ? -149
                         : sort == 1 ? 104
                         : sort == 2 ? random.between(-149, 103)
                                     : random.between(-26, -22);
    result.push_back(std::ldexp(sign * (sort == 3 ? static_cast<float>(random.between(0, 63)) : mantissa()), exponent));
  }
  return result;
}

TEST(PlaneDistance, comparisons_equal_those_of_rationals) {
  Random random(5);
  std::size_t checks = 0;
  std::size_t equal = 0;
  for (int i = 0; i < 40'000; ++i) {
    const std::vector<float> v = values(random, i % 4);
    const double plane = i % 97 == 0 ? std::copysign(0x1p128, v[0]) : static_cast<double>(v[0]);
    const float origin = v[1];
    const float direction = v[2] == 0 ? 1 : v[2];
    const Rational exact = (Rational(plane) - Rational(origin)) / Rational(direction);
    const auto nearest = static_cast<float>(static_cast<double>(exact));
    for (float t : {std::nextafter(nearest, -INFINITY), nearest, std::nextafter(nearest, INFINITY), 0.0F}) {
      if (!std::isfinite(t)) t = std::copysign(std::numeric_limits<float>::max(), t);
      ASSERT_EQ(not_after_plane(t, plane, origin, direction), Rational(t) <= exact) << i;
      ASSERT_EQ(not_before_plane(t, plane, origin, direction), Rational(t) >= exact) << i;
      equal += Rational(t) == exact;
      checks += 2;
    }
  }
  EXPECT_EQ(checks, 320'000U);
  EXPECT_GT(equal, 1000U) << "exact hits are the hard ones";
}

TEST(PlaneDistance, infinite_distances_enclose_from_their_own_side_only) {
  for (const float direction : {-3.0F, 0x1p-149F}) {
    EXPECT_TRUE(not_after_plane(-INFINITY, 1, 2, direction));
    EXPECT_TRUE(not_before_plane(INFINITY, 1, 2, direction));
    EXPECT_FALSE(not_after_plane(INFINITY, 1, 2, direction));
    EXPECT_FALSE(not_before_plane(-INFINITY, 1, 2, direction));
  }
}

}  // namespace
}  // namespace cbvh::golden
