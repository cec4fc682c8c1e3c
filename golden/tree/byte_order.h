// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <boost/crc.hpp>
#include <cstdint>
#include <string>
#include <string_view>

#include "golden/input_error.h"
#include "golden/quantize/exact.h"

namespace cbvh::golden {

/// CRC-32C (Castagnoli: 0x1EDC6F41, reflected).
inline std::uint32_t crc32c(std::string_view bytes) {
  boost::crc_optimal<32, 0x1EDC6F41, 0xFFFFFFFF, 0xFFFFFFFF, true, true> crc;
  crc.process_bytes(bytes.data(), bytes.size());
  return crc.checksum();
}

/// Appends little-endian numbers.
class ByteWriter {
 public:
  std::string bytes;

  void u8(std::uint8_t x) { bytes.push_back(static_cast<char>(x)); }
  void u32(std::uint32_t x) { number(x, 4); }
  void u64(std::uint64_t x) { number(x, 8); }
  void i32(std::int32_t x) { u32(static_cast<std::uint32_t>(x)); }
  void f32(float x) { u32(std::bit_cast<std::uint32_t>(x)); }
  /// Two's complement of 40 bytes: any cell index there is.
  void i320(const Wide& x) {
    for (int i = 0; i < 40; ++i) u8(static_cast<std::uint8_t>(modulo(floor_divide(x, 8 * i), 8)));
  }

 private:
  void number(std::uint64_t x, int count) {
    for (int i = 0; i < count; ++i) u8(static_cast<std::uint8_t>(x >> (8 * i)));
  }
};

/// Takes little-endian numbers; throws InputError with the offset where bytes are missing.
class ByteReader {
 public:
  ByteReader(std::string_view all, std::string file) : bytes(all), name(std::move(file)) {}

  std::uint8_t u8() { return static_cast<std::uint8_t>(number(1)); }
  std::uint32_t u32() { return static_cast<std::uint32_t>(number(4)); }
  std::uint64_t u64() { return number(8); }
  std::int32_t i32() { return static_cast<std::int32_t>(u32()); }
  float f32() { return std::bit_cast<float>(u32()); }
  Wide i320() {
    need(40);
    Wide x = static_cast<std::int8_t>(bytes[position + 39]);
    for (std::size_t i = 39; i-- > 0;) x = x * 256 + static_cast<std::uint8_t>(bytes[position + i]);
    position += 40;
    return x;
  }

  std::size_t offset() const { return position; }
  std::size_t left() const { return bytes.size() - position; }
  std::string_view between(std::size_t begin, std::size_t end) const { return bytes.substr(begin, end - begin); }
  void need(std::uint64_t count) const {
    if (count > left()) fail(bytes.size(), fmt::format("the file ends here, {} bytes more are wanted", count - left()));
  }
  [[noreturn]] void fail(std::size_t at, const std::string& what) const {
    throw InputError(fmt::format("{}:offset {}", name, at), what);
  }

 private:
  std::uint64_t number(std::size_t count) {
    need(count);
    std::uint64_t x = 0;
    for (std::size_t i = count; i-- > 0;) x = x << 8 | static_cast<std::uint8_t>(bytes[position + i]);
    position += count;
    return x;
  }

  std::string_view bytes;
  std::string name;
  std::size_t position = 0;
};

}  // namespace cbvh::golden
