// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/tree/digest.h"

#include "golden/tree/decode.h"

namespace cbvh::golden {
namespace {

class Fnv1a {
 public:
  void add(std::uint8_t byte) { hash = (hash ^ byte) * 0x100000001B3U; }
  void add(const CompressedPair& pair) {
    for (const CompressedChild& child : pair.child) {
      for (const AxisCodes& codes : child.codes) add(codes.lower);
      for (const AxisCodes& codes : child.codes) add(codes.upper);
      add(child.leaf ? 1 : 0);
      for (unsigned shift = 0; shift < 32; shift += 8) add(static_cast<std::uint8_t>(child.pointer >> shift));
    }
  }
  std::uint64_t value() const { return hash; }

 private:
  std::uint64_t hash = 0xCBF29CE484222325U;
};

}  // namespace

std::uint64_t digest(const CompressedTree& tree) {
  if (tree.code == Code::relative) return digest(to_code(tree, Code::modulo));
  Fnv1a hash;
  for (const CompressedPair& pair : tree.pairs) hash.add(pair);
  return hash.value();
}

}  // namespace cbvh::golden
