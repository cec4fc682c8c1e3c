// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_model/bits/operations.h"
#include "rtl_model/memory/array_reader.h"

namespace cbvh::rtl {

/// Entry `slot` of a line of the primitive-ID array.
constexpr IdEntry id_entry_of(const LineWords& line, std::size_t slot, UInt<1> last) {
  return {bits<kPointerBits - 1, 0>(line[slot]), bits<31, 31>(line[slot]), last};
}

/// Reads the primitive-ID array, an entry a clock, sixteen to a line. Paper section 5.2: refitting reads it, 4 bytes a
/// primitive, and leaves it as it is.
struct IdReader : ArrayReader<IdEntry, kWordsPerLine, id_entry_of> {
  using ArrayReader<IdEntry, kWordsPerLine, id_entry_of>::ArrayReader;
};

}  // namespace cbvh::rtl
