// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "golden/quantize/grid.h"
#include "golden/scene/mesh.h"

namespace cbvh::golden {

/// Bit 31 of an entry of the primitive-ID array: the last primitive of its leaf.
inline constexpr std::uint32_t kLastOfLeaf = 1U << 31;

/// More pairs or primitives than this do not fit the 27-bit pointers of a node pair.
inline constexpr std::uint64_t kMaxCount = std::uint64_t{1} << 27;

/// Two sibling nodes in binary32. Every float in a box is finite, and no zero is negative.
struct FloatPair {
  Box child[2];
  bool leaf[2];
  std::uint32_t
      pointer[2];  ///< of an inner child: its pair's index; of a leaf: its first entry in the primitive-ID array
};

/// A BVH before quantization.
struct FloatTree {
  std::vector<FloatPair>
      pairs;  ///< emission order: depth first, bottom up; children before parents, the root pair last
  std::vector<std::uint32_t> primitive_ids;  ///< leaf after leaf; kLastOfLeaf marks the last of its leaf. Each
                                             ///< primitive once, or in several leaves if the builder splits triangles
  std::uint32_t leaves = 0;                  ///< pairs.size() + 1; a scene that is one leaf has no pairs
  std::uint32_t primitives = 0;
  Box scene;                    ///< the root node's box
  float largest_magnitude = 0;  ///< the largest |coordinate| of the scene's primitive boxes (rule 3)
};

/// The smallest box around both.
Box unite(const Box& a, const Box& b);

/// The box of the node whose children this pair holds.
inline Box own_box(const FloatPair& pair) { return unite(pair.child[0], pair.child[1]); }

/// The largest |coordinate| of a box.
float largest_magnitude(const Box& box);

/// The box of each triangle, zeros positive. Throws InputError naming the triangle or vertex when the mesh does not
/// keep what mesh.h promises (DESIGN section 3, rule 1), and when it has no triangles or more than kMaxCount.
std::vector<Box> triangle_boxes(const Mesh& mesh);

/// Half the surface of a box, in binary64: extents of 2^129 are welcome.
double half_area(const Box& box);

/// Throws InputError when the counts do not fit the 27-bit pointers of a node pair; `place` names the scene.
void check_counts(const std::string& place, std::uint64_t references, std::uint64_t pairs);

}  // namespace cbvh::golden
