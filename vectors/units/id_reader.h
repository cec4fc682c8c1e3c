// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "golden/build/float_tree.h"
#include "vectors/units/array_reader.h"

namespace cbvh::vectors {

inline rtl::IdEntry id_entry_in(const LineMemory& memory, std::uint64_t first_line, std::uint64_t index) {
  const std::uint32_t word = memory.word(first_line * 16 + index);
  return {rtl::Pointer(word % golden::kMaxCount), rtl::UInt<1>((word & golden::kLastOfLeaf) != 0), {}};
}

/// Reads the primitive-ID array.
struct IdReader : ArrayReaderUnit<rtl::IdEntry, 16, id_entry_in> {
  static constexpr std::string_view kName = "id_reader";
  static constexpr std::string_view kSummary = "entries of the primitive-ID array in memory";
};

}  // namespace cbvh::vectors
