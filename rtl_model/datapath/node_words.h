// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "rtl_model/bits/operations.h"
#include "rtl_model/datapath/payloads.h"
#include "rtl_model/memory/line_port.h"

/// A node pair as four 32-bit words of memory, and four pairs as a line: wires in another order (DESIGN section 4).
/// Codes of fewer than six bits sit low in their fields; wider ones have no packed form.
namespace cbvh::rtl {

constexpr int kMostPackedBits = 6;
constexpr int kWordsPerPair = 4;

using PairWords = std::array<UInt<32>, kWordsPerPair>;

template <int N>
requires(N <= kMostPackedBits) constexpr UInt<64> pack_child(const NodeCodes<N>& child) {
  const auto field = [](UInt<N> code) { return UInt<kMostPackedBits>::of_raw(code.raw()); };
  const auto hi = concat(field(child.hi[2]), concat(field(child.hi[1]), field(child.hi[0])));
  const auto lo = concat(field(child.lo[2]), concat(field(child.lo[1]), field(child.lo[0])));
  return concat(concat(child.pointer, child.leaf), concat(hi, lo));
}

template <int N>
requires(N <= kMostPackedBits) constexpr NodeCodes<N> unpack_child(UInt<64> word) {
  NodeCodes<N> child;
  child.lo = {bits<N - 1, 0>(word), bits<N + 5, 6>(word), bits<N + 11, 12>(word)};
  child.hi = {bits<N + 17, 18>(word), bits<N + 23, 24>(word), bits<N + 29, 30>(word)};
  child.leaf = bits<36, 36>(word);
  child.pointer = bits<63, 37>(word);
  return child;
}

template <int N>
constexpr PairWords pack_pair(const NodePair<N>& pair) {
  const UInt<64> left = pack_child(pair.child[0]);
  const UInt<64> right = pack_child(pair.child[1]);
  return {bits<31, 0>(left), bits<63, 32>(left), bits<31, 0>(right), bits<63, 32>(right)};
}

template <int N>
constexpr NodePair<N> unpack_pair(const PairWords& words) {
  return {{unpack_child<N>(concat(words[1], words[0])), unpack_child<N>(concat(words[3], words[2]))}};
}

/// The words of pair `slot` of a line.
constexpr PairWords words_of_slot(const LineWords& line, std::size_t slot) {
  const std::size_t first = slot * kWordsPerPair;
  return {line[first], line[first + 1], line[first + 2], line[first + 3]};
}

/// A write of some pairs as a write of their words; `first_line` is where pair 0 lies.
template <int N>
constexpr LineRequest pack_write(const MemoryRequest<N>& request, LineAddress first_line) {
  LineRequest packed;
  packed.write = UInt<1>(1);
  packed.line = truncate<kLineAddressBits>(first_line + request.line);
  std::uint64_t mask = 0;
  for (std::size_t slot = 0; slot < kPairsPerLine; ++slot) {
    if ((request.mask.raw() >> slot & 1u) == 0) continue;
    const PairWords words = pack_pair(request.pairs[slot]);
    for (std::size_t i = 0; i < kWordsPerPair; ++i) packed.words[slot * kWordsPerPair + i] = words[i];
    mask |= std::uint64_t{0xF} << (slot * kWordsPerPair);
  }
  packed.mask = UInt<kWordsPerLine>(mask);
  return packed;
}

template <int N>
constexpr MemoryLine<N> unpack_line(const LineWords& words) {
  MemoryLine<N> line;
  for (std::size_t slot = 0; slot < kPairsPerLine; ++slot) {
    line.pairs[slot] = unpack_pair<N>(words_of_slot(words, slot));
  }
  return line;
}

}  // namespace cbvh::rtl
