// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "golden/build/float_tree.h"
#include "golden/tree/compressed_tree.h"

namespace cbvh::golden {

/// One thing wrong with a tree, and where.
struct Violation {
  enum class Where : std::uint8_t { header, pair, primitive_id };
  Where where;
  std::uint32_t index;  ///< of the pair or of the primitive-ID entry; 0 for the header
  int child;            ///< 0 or 1; -1 where the whole pair is meant or there is none
  std::string what;     ///< what was found and what was wanted
};

/// "pair 12, child 1: ...".
std::string to_string(const Violation& violation);

/// Checks a tree that may hold anything: the rules and counts agree; every pointer is in range; every pair is reached
/// exactly once from the root, so there is no cycle; leaves are disjoint, reach every primitive and
/// have none twice (several leaves may share one: builders that split triangles make such trees); every code fits its
/// bits; every quantized box is a box, lies in its parent's and spans no more cells than the rules allow. Exact; at
/// most `most` violations are returned.
std::vector<Violation> validate(const CompressedTree& tree, std::size_t most = 100);

/// All of that, and: the tree has the float tree's pairs and leaves, and every quantized box encloses its float box.
std::vector<Violation> validate(const CompressedTree& tree, const FloatTree& floats, std::size_t most = 100);

}  // namespace cbvh::golden
