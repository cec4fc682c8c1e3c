// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/tree/float_pair_format.h"

#include <gtest/gtest.h>

#include "golden/input_error.h"

namespace cbvh::golden {
namespace {

const FloatPair kPair{{{{1, -2, 0}, {3, 4, 0.5F}}, {{-1, -1, -1}, {0, 0, 1e-45F}}}, {false, true}, {5, (1U << 27) - 1}};

TEST(FloatPairFormat, a_pair_is_sixteen_words_child_after_child) {
  const FloatPairWords want = {0x3F800000, 0xC0000000, 0,          0x40400000, 0x40800000, 0x3F000000, 5,          0,
                               0xBF800000, 0xBF800000, 0xBF800000, 0,          0,          1,          0x87FFFFFF, 0};
  EXPECT_EQ(pack_float_pair(kPair), want);
}

TEST(FloatPairFormat, a_pointer_of_28_bits_is_refused) {
  FloatPair pair = kPair;
  pair.pointer[0] = 1U << 27;
  EXPECT_THROW(pack_float_pair(pair), InputError);
}

}  // namespace
}  // namespace cbvh::golden
