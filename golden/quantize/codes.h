// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "golden/quantize/exact.h"
#include "golden/quantize/grid.h"

namespace cbvh::golden {

/// One axis of one child as it is stored: N-bit codes (2^N is stored as 0).
struct AxisCodes {
  std::uint8_t lower;
  std::uint8_t upper;
  bool operator==(const AxisCodes&) const = default;
};

/// Codes of a child's cells on its parent's own grid; `parent_lower` is the parent's own lower index there (DESIGN
/// section 3, rule 5; the paper's equations 1 and 8). The cells must lie within parent_lower .. parent_lower + 2^bits.
template <class Index>
AxisCodes encode_codes(const Cells<Index>& cells, const Index& parent_lower, Code code, int bits) {
  const Index origin = code == Code::relative ? parent_lower : Index{0};
  return {static_cast<std::uint8_t>(modulo(Index(cells.lower - origin), bits)),
          static_cast<std::uint8_t>(modulo(Index(cells.upper - origin), bits))};
}

/// The cells that codes stand for (rule 5; the paper's equations 3 and 9, with the condition of 9 corrected to "s =
/// 0").
template <class Index>
Cells<Index> decode_codes(AxisCodes codes, const Index& parent_lower, Code code, int bits) {
  const std::int64_t origin = code == Code::modulo ? modulo(parent_lower, bits) : 0;
  const std::int64_t r = modulo(std::int64_t{codes.lower} - origin, bits);
  const std::int64_t s = modulo(std::int64_t{codes.upper} - origin, bits);
  return {Index(parent_lower + r), Index(parent_lower + (s == 0 ? std::int64_t{1} << bits : s))};
}

}  // namespace cbvh::golden
