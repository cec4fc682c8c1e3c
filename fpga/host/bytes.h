// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "vectors/format/crc32c.h"

/// Little-endian integers in sequences of bytes, as the board link has them.
namespace cbvh::host {

using Bytes = std::vector<std::uint8_t>;
using ByteSpan = std::span<const std::uint8_t>;

template <std::unsigned_integral T>
void append(Bytes& bytes, T value) {
  for (std::size_t i = 0; i < sizeof(T); ++i)
    bytes.push_back(static_cast<std::uint8_t>(std::uint64_t{value} >> (8 * i)));
}
inline void append(Bytes& bytes, ByteSpan more) { bytes.insert(bytes.end(), more.begin(), more.end()); }

/// The integer at `offset`, which must lie inside.
template <std::unsigned_integral T>
T read_at(ByteSpan bytes, std::size_t offset) {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < sizeof(T); ++i) value |= std::uint64_t{bytes[offset + i]} << (8 * i);
  return static_cast<T>(value);
}

/// Takes integers and bytes off the front. Once it has been asked for more than there is, it gives zeros and ok() is
/// false.
class ByteReader {
 public:
  explicit ByteReader(ByteSpan bytes) : bytes_(bytes) {}

  template <std::unsigned_integral T>
  T take() {
    const ByteSpan taken = take(sizeof(T));
    return taken.empty() ? T{0} : read_at<T>(taken, 0);
  }
  /// Empty when there are fewer than `count`.
  ByteSpan take(std::uint64_t count) {
    if (count > bytes_.size()) {
      ok_ = false;
      bytes_ = {};
      return {};
    }
    const ByteSpan taken = bytes_.first(static_cast<std::size_t>(count));
    bytes_ = bytes_.subspan(static_cast<std::size_t>(count));
    return taken;
  }

  bool ok() const { return ok_; }
  /// Everything was there, and nothing is left.
  bool finished() const { return ok_ && bytes_.empty(); }

 private:
  ByteSpan bytes_;
  bool ok_ = true;
};

inline std::uint32_t crc32c(ByteSpan bytes) {
  vectors::Crc32c crc;
  crc.update({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  return crc.value();
}
inline std::uint32_t crc32c(std::string_view text) {
  vectors::Crc32c crc;
  crc.update(text);
  return crc.value();
}

}  // namespace cbvh::host
