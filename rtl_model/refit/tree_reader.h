// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_model/datapath/node_words.h"
#include "rtl_model/memory/array_reader.h"

namespace cbvh::rtl {

/// Leaf bits and pointers of pair `slot` of a line; its codes, whatever their width, do not matter.
constexpr TopologyPair topology_of(const LineWords& line, std::size_t slot, UInt<1> last) {
  const NodePair<kMostPackedBits> pair = unpack_pair<kMostPackedBits>(words_of_slot(line, slot));
  return {{pair.child[0].leaf, pair.child[1].leaf}, {pair.child[0].pointer, pair.child[1].pointer}, last};
}

/// Reads an existing tree's topology in emission order, a pair a clock, four to a line. Paper section 5.2: refitting
/// reads the hierarchy, 16 bytes a pair.
struct TreeReader : ArrayReader<TopologyPair, kPairsPerLine, topology_of> {
  using ArrayReader<TopologyPair, kPairsPerLine, topology_of>::ArrayReader;
};

}  // namespace cbvh::rtl
