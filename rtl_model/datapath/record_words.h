// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_model/bits/operations.h"
#include "rtl_model/datapath/lbvh_payloads.h"

/// Payloads of the LBVH builder as the words of memory lines, and back. Wiring only.
namespace cbvh::rtl {

/// A box as six words: lower x y z, upper x y z.
constexpr void put_box(const FloatBox& box, LineWords& words, std::size_t first) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    words[first + axis] = UInt<32>(box.lower[axis].raw());
    words[first + 3 + axis] = UInt<32>(box.upper[axis].raw());
  }
}
constexpr FloatBox box_at(const LineWords& words, std::size_t first) {
  FloatBox box;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    box.lower[axis] = Float32::of_raw(words[first + axis].raw());
    box.upper[axis] = Float32::of_raw(words[first + 3 + axis].raw());
  }
  return box;
}

/// Record `slot` (0 or 1) of a line: its box, code and id.
constexpr void put_record(const SortRecord& record, LineWords& words, std::size_t slot) {
  const std::size_t first = slot * kWordsPerRecord;
  put_box(record.box, words, first);
  words[first + 6] = record.code;
  words[first + 7] = record.id;
}
constexpr SortRecord record_at(const LineWords& words, std::size_t slot) {
  const std::size_t first = slot * kWordsPerRecord;
  return {box_at(words, first), truncate<kMortonBits>(words[first + 6]), truncate<kPointerBits>(words[first + 7])};
}

/// A node pair in binary32: a line. Of each child its box, then pointer | leaf << 31, then zero.
constexpr LineWords float_pair_words(const FloatPair& pair) {
  LineWords words{};
  for (std::size_t child = 0; child < 2; ++child) {
    put_box(pair.box[child], words, child * 8);
    words[child * 8 + 6] = concat(pair.leaf[child], UInt<31>(pair.pointer[child]));
  }
  return words;
}

constexpr FloatPair float_pair_at(const LineWords& words) {
  FloatPair pair;
  for (std::size_t child = 0; child < 2; ++child) {
    pair.box[child] = box_at(words, child * 8);
    pair.leaf[child] = bits<31, 31>(words[child * 8 + 6]);
    pair.pointer[child] = bits<kPointerBits - 1, 0>(words[child * 8 + 6]);
  }
  return pair;
}

/// An entry of the primitive-ID array.
constexpr UInt<32> id_word(const IdEntry& entry) { return concat(entry.last_of_leaf, UInt<31>(entry.id)); }

}  // namespace cbvh::rtl
