// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "vectors/units/array_reader.h"

namespace cbvh::vectors {

inline rtl::TopologyPair topology_in(const LineMemory& memory, std::uint64_t first_line, std::uint64_t index) {
  const golden::CompressedPair pair = memory.pair(first_line, index);
  rtl::TopologyPair topology;
  for (std::size_t c = 0; c < 2; ++c) {
    topology.leaf[c] = rtl::UInt<1>(pair.child[c].leaf);
    topology.pointer[c] = rtl::Pointer(pair.child[c].pointer);
  }
  return topology;
}

/// Reads leaf bits and pointers of packed pairs.
struct TreeReader : ArrayReaderUnit<rtl::TopologyPair, 4, topology_in> {
  static constexpr std::string_view kName = "tree_reader";
  static constexpr std::string_view kSummary = "leaf bits and pointers of the packed pairs in memory";
};

}  // namespace cbvh::vectors
