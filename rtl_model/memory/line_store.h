// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "rtl_model/memory/line_port.h"

namespace cbvh::rtl {

/// What a memory holds, without its timing. Never written lines read as zeros.
class LineStore {
 public:
  explicit LineStore(std::uint64_t capacity_lines) : capacity_lines_(capacity_lines) {}

  std::uint64_t capacity_lines() const { return capacity_lines_; }
  /// The first line beyond the capacity that was asked for: the run is void.
  std::optional<std::uint64_t> out_of_range() const { return out_of_range_; }

  void write(const LineRequest& request) {
    const std::uint64_t line = request.line.value();
    if (!in_range(line)) return;
    grow(line + 1);
    for (std::size_t i = 0; i < kWordsPerLine; ++i) {
      if (request.mask.value() >> i & 1u) words_[line * kWordsPerLine + i] = word(request.words[i]);
    }
  }
  LineData read(LineAddress address) {
    const std::uint64_t line = address.value();
    LineData data;
    if (!in_range(line) || (line + 1) * kWordsPerLine > words_.size()) return data;
    for (std::size_t i = 0; i < kWordsPerLine; ++i) data.words[i] = UInt<32>(words_[line * kWordsPerLine + i]);
    return data;
  }

  /// The driver's view, by word address. Beyond what was written: zero.
  std::uint32_t peek(std::uint64_t index) const { return index < words_.size() ? words_[index] : 0; }
  void poke(std::uint64_t index, std::uint32_t value) {
    if (!in_range(index / kWordsPerLine)) return;
    grow(index / kWordsPerLine + 1);
    words_[index] = value;
  }

 private:
  static std::uint32_t word(UInt<32> wire) { return static_cast<std::uint32_t>(wire.value()); }
  void grow(std::uint64_t lines) {
    if (words_.size() < lines * kWordsPerLine) words_.resize(lines * kWordsPerLine);
  }
  bool in_range(std::uint64_t line) {
    if (line < capacity_lines_) return true;
    if (!out_of_range_) out_of_range_ = line;
    return false;
  }

  std::uint64_t capacity_lines_;
  std::optional<std::uint64_t> out_of_range_;
  std::vector<std::uint32_t> words_;
};

}  // namespace cbvh::rtl
