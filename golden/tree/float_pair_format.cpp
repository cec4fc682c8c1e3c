// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/tree/float_pair_format.h"

#include <bit>

#include "golden/input_error.h"

namespace cbvh::golden {

FloatPairWords pack_float_pair(const FloatPair& pair) {
  FloatPairWords words{};
  auto word = words.begin();
  for (int child = 0; child < 2; ++child) {
    const Box& box = pair.child[child];
    for (int axis = 0; axis < 3; ++axis) *word++ = std::bit_cast<std::uint32_t>(box.lower[axis]);
    for (int axis = 0; axis < 3; ++axis) *word++ = std::bit_cast<std::uint32_t>(box.upper[axis]);
    if (pair.pointer[child] >= kMaxCount)
      throw InputError("node pair", fmt::format("pointer {}, want below 2^27", pair.pointer[child]));
    *word++ = pair.pointer[child] + (pair.leaf[child] ? 0x80000000U : 0U);
    *word++ = 0;
  }
  return words;
}

}  // namespace cbvh::golden
