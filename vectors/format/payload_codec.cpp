// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "vectors/format/payload_codec.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <optional>

namespace cbvh::vectors {
namespace {

static_assert(std::endian::native == std::endian::little);

// A copy of a size known to the compiler is one instruction.
template <class T>
std::uint64_t load_as(const char* at) {
  T raw;
  std::memcpy(&raw, at, sizeof raw);
  return raw;
}

template <class T>
void store_as(char* at, std::uint64_t value) {
  const auto raw = static_cast<T>(value);
  std::memcpy(at, &raw, sizeof raw);
}

std::uint64_t load(const CodecLeaf& leaf, const void* payload) {
  const char* const at = static_cast<const char*>(payload) + leaf.offset;
  switch (leaf.size) {
    case 1:
      return load_as<std::uint8_t>(at);
    case 2:
      return load_as<std::uint16_t>(at);
    case 4:
      return load_as<std::uint32_t>(at);
    default:
      return load_as<std::uint64_t>(at);
  }
}

void store(const CodecLeaf& leaf, void* payload, std::uint64_t raw) {
  char* const at = static_cast<char*>(payload) + leaf.offset;
  switch (leaf.size) {
    case 1:
      return store_as<std::uint8_t>(at, raw);
    case 2:
      return store_as<std::uint16_t>(at, raw);
    case 4:
      return store_as<std::uint32_t>(at, raw);
    default:
      return store_as<std::uint64_t>(at, raw);
  }
}

constexpr std::size_t kWordBytes = 8;

/// Where the eight bytes begin that hold bits [bit, bit + width) of so many bytes; nothing if there are no such eight.
std::optional<std::size_t> word_of(std::size_t size, std::size_t bit, int width) {
  if (size < kWordBytes) return std::nullopt;
  const std::size_t first = std::min(bit / 8, size - kWordBytes);
  if (bit - 8 * first + static_cast<std::size_t>(width) > 64) return std::nullopt;
  return first;
}

std::uint64_t get_bits(const std::uint8_t* bytes, std::size_t size, std::size_t bit, int width) {
  std::uint64_t raw = 0;
  if (const auto first = word_of(size, bit, width)) {
    std::memcpy(&raw, bytes + *first, kWordBytes);
    return (raw >> (bit - 8 * *first)) & rtl::low_mask(width);
  }
  for (int done = 0; done < width;) {
    const auto used = static_cast<int>(bit % 8);
    raw |= static_cast<std::uint64_t>(bytes[bit / 8] >> used) << done;
    bit += static_cast<std::size_t>(8 - used);
    done += 8 - used;
  }
  return raw & rtl::low_mask(width);
}

template <class Count>
std::size_t sum(const std::vector<CodecLeaf>& leaves, Count&& count) {
  std::size_t total = 0;
  for (const CodecLeaf& leaf : leaves) total += static_cast<std::size_t>(count(leaf.width));
  return total;
}

}  // namespace

namespace detail {

std::string element_path(const std::string& path, std::size_t size, std::size_t index) {
  const std::string name = size == 3 ? std::string(1, static_cast<char>('x' + index)) : std::to_string(index);
  return path.empty() ? name : path + "_" + name;
}

std::string field_path(const std::string& path, const char* name) { return path.empty() ? name : path + "_" + name; }

}  // namespace detail

PayloadCodec::PayloadCodec(std::vector<CodecLeaf> leaf_table, std::size_t size, Parse parse)
    : leaves(std::move(leaf_table)),
      width(sum(leaves, [](int w) { return w; })),
      text_length(sum(leaves, [](int w) { return hex_digits(w) + 1; }) - 1),
      object_size(size),
      parse_(parse) {}

std::string PayloadCodec::field_names() const {
  std::string names;
  for (const CodecLeaf& leaf : leaves) names += (names.empty() ? "" : ":") + leaf.name;
  return names;
}

bool PayloadCodec::parse_by_table(const char* text, void* payload) const {
  unsigned bad = 0;
  const char* const end = text + text_length;
  for (const CodecLeaf& leaf : leaves) {
    std::uint64_t raw = 0;
    for (int left = hex_digits(leaf.width); left > 0; --left) {
      const std::uint8_t digit = detail::kDigitValues[static_cast<std::uint8_t>(*text++)];
      bad |= digit & detail::kNoDigit;
      raw = (raw << 4) | (digit & 0xFU);
    }
    if (raw > rtl::low_mask(leaf.width)) return false;
    store(leaf, payload, raw);
    if (text != end && *text++ != ' ') return false;
  }
  return bad == 0;
}

void PayloadCodec::print_text(const void* payload, char* text) const {
  const char* const end = text + text_length;
  for (const CodecLeaf& leaf : leaves) {
    std::uint64_t raw = load(leaf, payload);
    const int digits = hex_digits(leaf.width);
    for (int i = digits - 1; i >= 0; --i, raw >>= 4) text[i] = "0123456789ABCDEF"[raw & 0xF];
    text += digits;
    if (text != end) *text++ = ' ';
  }
}

void PayloadCodec::pack(const void* payload, std::uint8_t* bytes) const {
  std::uint64_t word = 0;  // what is not written yet
  int used = 0;            // its bits, below 64
  for (const CodecLeaf& leaf : leaves) {
    const std::uint64_t raw = load(leaf, payload) & rtl::low_mask(leaf.width);
    word |= raw << used;
    used += leaf.width;
    if (used < 64) continue;
    std::memcpy(bytes, &word, kWordBytes);
    bytes += kWordBytes;
    used -= 64;
    word = used == 0 ? 0 : raw >> (leaf.width - used);
  }
  std::memcpy(bytes, &word, static_cast<std::size_t>(used + 7) / 8);
}

bool PayloadCodec::unpack(const std::uint8_t* bytes, void* payload) const {
  const std::size_t size = packed_bytes();
  std::size_t bit = 0;
  for (const CodecLeaf& leaf : leaves) {
    store(leaf, payload, get_bits(bytes, size, bit, leaf.width));
    bit += static_cast<std::size_t>(leaf.width);
  }
  return bit % 8 == 0 || (bytes[bit / 8] >> (bit % 8)) == 0;
}

}  // namespace cbvh::vectors
