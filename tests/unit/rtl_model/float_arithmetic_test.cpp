// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "rtl_model/datapath/float_arithmetic.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <vector>

#include "rtl_model/kernel/random.h"

namespace cbvh::rtl {
namespace {

using F = MachineBits::F;

/// Around every border of the format: zero, subnormals, the smallest normals, ones, halves between integers, the
/// largest, infinity, NaN; of both signs.
std::vector<std::uint32_t> boundary_floats() {
  std::vector<std::uint32_t> values;
  for (const std::uint32_t magnitude :
       {0x00000000U, 0x00000001U, 0x00000002U, 0x00000003U, 0x00400000U, 0x007FFFFEU, 0x007FFFFFU, 0x00800000U,
        0x00800001U, 0x00FFFFFFU, 0x01000000U, 0x01000001U, 0x01800001U, 0x0B800000U, 0x0C000001U, 0x33800000U,
        0x34000000U, 0x3EFFFFFFU, 0x3F000000U, 0x3F7FFFFFU, 0x3F800000U, 0x3F800001U, 0x3FFFFFFFU, 0x40490FDBU,
        0x4AFFFFFFU, 0x4B000000U, 0x4B7FFFFFU, 0x4B800000U, 0x7E7FFFFFU, 0x7E800000U, 0x7EFFFFFFU, 0x7F000000U,
        0x7F7FFFFEU, 0x7F7FFFFFU, 0x7F800000U, 0x7F800001U, 0x7FC00000U, 0x7FFFFFFFU}) {
    values.push_back(magnitude);
    values.push_back(magnitude | 0x80000000U);
  }
  return values;
}

/// What the hardware is to give: the host's result, every NaN the same.
std::uint32_t expected(float result) { return std::isnan(result) ? 0x7FC00000U : std::bit_cast<std::uint32_t>(result); }

void expect_all_operations(std::uint32_t a_bits, std::uint32_t b_bits) {
  const auto a = std::bit_cast<float>(a_bits);
  const auto b = std::bit_cast<float>(b_bits);
  const F x = F::of_raw(a_bits);
  const F y = F::of_raw(b_bits);
  ASSERT_EQ(add_floats<MachineBits>(x, y).raw(), expected(a + b)) << std::hex << a_bits << ' ' << b_bits;
  ASSERT_EQ(subtract_floats<MachineBits>(x, y).raw(), expected(a - b)) << std::hex << a_bits << ' ' << b_bits;
  ASSERT_EQ(divide_floats<MachineBits>(x, y).raw(), expected(a / b)) << std::hex << a_bits << ' ' << b_bits;
}
void expect_scaling(std::uint32_t bits) {
  const auto a = std::bit_cast<float>(bits);
  const F x = F::of_raw(bits);
  ASSERT_EQ((scale_down<MachineBits, 1>(x).raw()), expected(a * 0.5F)) << std::hex << bits;
  ASSERT_EQ((scale_down<MachineBits, 2>(x).raw()), expected(a * 0.25F)) << std::hex << bits;
  ASSERT_EQ((scale_down<MachineBits, 24>(x).raw()), expected(a * 0x1p-24F)) << std::hex << bits;
}

TEST(FloatArithmetic, is_the_hosts_bit_for_bit_on_all_pairs_of_boundaries) {
  const auto values = boundary_floats();
  for (const std::uint32_t a : values) {
    expect_scaling(a);
    for (const std::uint32_t b : values) {
      expect_all_operations(a, b);
      if (HasFatalFailure()) return;
    }
  }
}

TEST(FloatArithmetic, is_the_hosts_bit_for_bit_on_two_million_random_pairs_near_and_far) {
  SplitMix64 random(17);
  std::size_t subnormal_quotients = 0;
  for (int i = 0; i < 2'000'000; ++i) {
    auto a = static_cast<std::uint32_t>(random.next());
    auto b = static_cast<std::uint32_t>(random.next());
    switch (i % 6) {
      case 1:  // near in size: sums cancel
        b = (b & 0x80FFFFFFU) | (a & 0x7F000000U);
        break;
      case 2:  // a few last places apart
        b = (a ^ (b & 0x80000000U)) + b % 5;
        break;
      case 3:  // both small
        a &= 0x81FFFFFFU;
        b &= 0x81FFFFFFU;
        break;
      case 4:  // few significant bits: ties
        a &= 0xFFFC0000U;
        b &= 0xFFC00000U;
        break;
      case 5:  // quotients around the smallest normal number
        a = (a & 0x807FFFFFU) | static_cast<std::uint32_t>(random.below(40)) << 23;
        b = (b & 0x807FFFFFU) | (126 + static_cast<std::uint32_t>(random.below(40))) << 23;
        subnormal_quotients += std::fpclassify(std::bit_cast<float>(a) / std::bit_cast<float>(b)) == FP_SUBNORMAL;
        break;
      default:
        break;
    }
    expect_all_operations(a, b);
    expect_scaling(a);
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(subnormal_quotients, 50'000U);
}

}  // namespace
}  // namespace cbvh::rtl
