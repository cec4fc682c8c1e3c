// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "rtl_model/bits/machine_bits.h"
#include "rtl_model/kernel/random.h"

namespace cbvh::rtl {
namespace {

TEST(SizedBits, sums_and_differences_grow_so_that_no_value_is_lost) {
  for (std::uint64_t a = 0; a < 32; ++a) {
    for (std::uint64_t b = 0; b < 8; ++b) {
      const auto sum = UInt<5>(a) + UInt<3>(b);
      const auto difference = UInt<5>(a) - UInt<3>(b);
      static_assert(decltype(sum)::kWidth == 6 && decltype(difference)::kWidth == 6 && decltype(difference)::kSigned);
      EXPECT_EQ(sum.value(), a + b);
      EXPECT_EQ(difference.value(), static_cast<std::int64_t>(a) - static_cast<std::int64_t>(b));
    }
  }
  for (std::int64_t a = -16; a < 16; ++a) {
    for (std::int64_t b = -8; b < 8; ++b) {
      EXPECT_EQ((SInt<5>(a) + SInt<4>(b)).value(), a + b);
      EXPECT_EQ((SInt<5>(a) - SInt<4>(b)).value(), a - b);
    }
  }
}

TEST(SizedBits, shifts_by_the_width_or_more_leave_only_sign_bits) {
  for (std::uint64_t distance = 0; distance < 16; ++distance) {
    for (std::int64_t value = -32; value < 32; ++value) {
      const auto shifted = shift_right(SInt<6>(value), UInt<4>(distance));
      EXPECT_EQ(shifted.value(), value >> distance);
    }
    for (std::uint64_t value = 0; value < 64; ++value) {
      EXPECT_EQ(shift_right(UInt<6>(value), UInt<4>(distance)).value(), value >> distance);
      EXPECT_EQ(shift_left(UInt<6>(value), UInt<4>(distance)).value(), (value << distance) & 63);
      const bool lost = ((value >> distance) << distance) != value;
      EXPECT_EQ(dropped_bits(UInt<6>(value), UInt<4>(distance)).value(), lost ? 1u : 0u);
    }
  }
}

TEST(SizedBits, modulo_bits_of_a_negative_number_is_its_residue) {
  for (std::int64_t value = -512; value < 512; ++value) {
    const std::int64_t residue = ((value % 64) + 64) % 64;
    EXPECT_EQ(static_cast<std::int64_t>(modulo_bits<6>(SInt<10>(value)).value()), residue);
  }
}

TEST(SizedBits, wires_of_64_bits_work) {
  SplitMix64 random(7);
  for (int i = 0; i < 1000; ++i) {
    const std::uint64_t value = random.next();
    EXPECT_EQ((UInt<64>(value) & UInt<64>(~value)).value(), 0u);
    EXPECT_EQ(SInt<64>(static_cast<std::int64_t>(value)).raw(), value);
    EXPECT_EQ(count_leading_zeros(UInt<64>(value >> 40)).value(),
              static_cast<std::uint64_t>(std::countl_zero(value >> 40)));
  }
}

TEST(SizedBits, concat_and_bits_take_each_other_apart) {
  for (std::uint64_t high = 0; high < 8; ++high) {
    for (std::uint64_t low = 0; low < 16; ++low) {
      const auto both = concat(UInt<3>(high), UInt<4>(low));
      EXPECT_EQ((bits<6, 4>(both).value()), high);
      EXPECT_EQ((bits<3, 0>(both).value()), low);
    }
  }
}

TEST(SizedBits, stored_register_is_no_wider_than_the_next_machine_type) {
  EXPECT_EQ(sizeof(UInt<8>), 1u);
  EXPECT_EQ(sizeof(UInt<9>), 2u);
  EXPECT_EQ(sizeof(SInt<26>), 4u);
}

}  // namespace
}  // namespace cbvh::rtl
