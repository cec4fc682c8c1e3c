// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/tree/node_pair_format.h"

#include "golden/build/float_tree.h"
#include "golden/input_error.h"

namespace cbvh::golden {
namespace {

std::uint64_t pack(const CompressedChild& child) {
  if (child.pointer >= kMaxCount)
    throw InputError("node pair", fmt::format("pointer {}, want below 2^27", child.pointer));
  std::uint64_t word = child.pointer;
  word = word * 2 + (child.leaf ? 1 : 0);
  const auto append = [&word](std::uint8_t code) {
    if (code >= 64) throw InputError("node pair", fmt::format("code {}, want six bits", code));
    word = word * 64 + code;
  };
  for (std::size_t axis = 3; axis-- > 0;) append(child.codes[axis].upper);
  for (std::size_t axis = 3; axis-- > 0;) append(child.codes[axis].lower);
  return word;
}

CompressedChild unpack(std::uint64_t word) {
  CompressedChild child{};
  const auto next = [&word] {
    const auto code = static_cast<std::uint8_t>(word % 64);
    word /= 64;
    return code;
  };
  for (AxisCodes& codes : child.codes) codes.lower = next();
  for (AxisCodes& codes : child.codes) codes.upper = next();
  child.leaf = word % 2 == 1;
  child.pointer = static_cast<std::uint32_t>(word / 2);
  return child;
}

}  // namespace

NodePairWords pack_node_pair(const CompressedPair& pair) { return {pack(pair.child[0]), pack(pair.child[1])}; }

CompressedPair unpack_node_pair(const NodePairWords& words) { return {{unpack(words[0]), unpack(words[1])}}; }

}  // namespace cbvh::golden
