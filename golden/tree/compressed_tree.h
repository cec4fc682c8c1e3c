// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "golden/quantize/codes.h"
#include "golden/quantize/grid.h"

namespace cbvh::golden {

struct FloatTree;

/// One quantized node, as its parent's pair stores it.
struct CompressedChild {
  std::array<AxisCodes, 3> codes;
  bool leaf;
  std::uint32_t pointer;  ///< of an inner child: its pair's index; of a leaf: its first entry in the primitive-ID array
  bool operator==(const CompressedChild&) const = default;
};

/// Two quantized siblings: what the hardware stores in 16 bytes.
struct CompressedPair {
  CompressedChild child[2];
  bool operator==(const CompressedPair&) const = default;
};

/// A quantized BVH. `pairs` and `primitive_ids` are laid out as in the FloatTree it came from.
struct CompressedTree {
  std::vector<CompressedPair> pairs;  ///< children before parents, the root pair last; empty when the scene is one leaf
  std::vector<std::uint32_t> primitive_ids;  ///< leaf after leaf; bit 31 marks the last of its leaf
  std::uint32_t leaves = 0;
  std::uint32_t primitives = 0;
  Box scene;  ///< the root node's float box
  Code code = Code::modulo;
  GridRules rules;
  Context<Wide> root;  ///< the root's own grid and lower index per axis, from `scene` (DESIGN section 3, rule 4)
};

/// A compressed tree of a float tree with everything but the contents of its pairs: where a compressor starts. Throws
/// InputError when the rules are out of their domain.
CompressedTree blank_compressed_tree(const FloatTree& tree, const GridRules& rules, Code code);

}  // namespace cbvh::golden
