// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <type_traits>
#include <vector>

#include "rtl_model/bits/fields.h"

/// A payload as text and as packed bits. Everything here is derived from its field list; the formats see payloads only
/// through PayloadCodec.
namespace cbvh::vectors {

constexpr int hex_digits(int width) { return (width + 3) / 4; }

namespace detail {

constexpr std::uint8_t kNoDigit = 0xF0;
constexpr std::array<std::uint8_t, 256> make_digit_values() {
  std::array<std::uint8_t, 256> values{};
  for (auto& value : values) value = kNoDigit;
  for (std::uint8_t d = 0; d < 10; ++d) values['0' + d] = d;
  for (std::uint8_t d = 0; d < 6; ++d) values['A' + d] = values['a' + d] = static_cast<std::uint8_t>(10 + d);
  return values;
}
constexpr std::array<std::uint8_t, 256> kDigitValues = make_digit_values();

/// The bits [bit, bit + width) of a packed payload; bit 0 is the lowest of byte 0.
inline void put_bits(std::uint8_t* bytes, int bit, int width, std::uint64_t raw) {
  while (width > 0) {
    const int used = bit & 7;
    const int taken = width < 8 - used ? width : 8 - used;
    bytes[bit >> 3] = static_cast<std::uint8_t>(bytes[bit >> 3] | ((raw & rtl::low_mask(taken)) << used));
    raw >>= taken;
    bit += taken;
    width -= taken;
  }
}
inline std::uint64_t get_bits(const std::uint8_t* bytes, int bit, int width) {
  std::uint64_t raw = 0;
  for (int done = 0; done < width;) {
    const int used = bit & 7;
    const int taken = width - done < 8 - used ? width - done : 8 - used;
    raw |= ((static_cast<std::uint64_t>(bytes[bit >> 3]) >> used) & rtl::low_mask(taken)) << done;
    bit += taken;
    done += taken;
  }
  return raw;
}

template <class T>
constexpr int leaf_count() {
  int count = 0;
  T value{};
  rtl::visit_leaves(value, [&](const auto&) { ++count; });
  return count;
}

template <class T>
constexpr int text_length() {
  int length = -1;
  T value{};
  rtl::visit_leaves(value,
                    [&](const auto& leaf) { length += 1 + hex_digits(std::remove_cvref_t<decltype(leaf)>::kWidth); });
  return length;
}

}  // namespace detail

/// What the formats need to know of a payload type. Functions take the object's address.
struct PayloadCodec {
  std::vector<rtl::LeafDescription> leaves;  ///< in order
  std::size_t width;                         ///< bits
  std::size_t text_length;                   ///< hex digits of all leaves, with a blank between two
  std::size_t object_size;                   ///< sizeof the type, which is trivially copyable

  /// Reads exactly text_length characters; false when a character is not what it must be or a value does not fit its
  /// field. Then the object's content is arbitrary.
  bool (*parse_text)(const char* text, void* payload);
  /// Writes exactly text_length characters.
  void (*print_text)(const void* payload, char* text);
  /// First leaf in the lowest bits; packed_bytes() bytes, padding zero.
  void (*pack)(const void* payload, std::uint8_t* bytes);
  /// False when a padding bit is set.
  bool (*unpack)(const std::uint8_t* bytes, void* payload);

  std::size_t packed_bytes() const { return (width + 7) / 8; }
  /// The names of the leaves, joined by ':'.
  std::string field_names() const {
    std::string names;
    for (const auto& leaf : leaves) names += (names.empty() ? "" : ":") + leaf.name;
    return names;
  }
};

template <class T>
bool parse_payload_text(const char* text, T& value) {
  unsigned bad = 0;
  int left = detail::leaf_count<T>();
  rtl::visit_leaves(value, [&](auto& leaf) {
    using L = std::remove_cvref_t<decltype(leaf)>;
    std::uint64_t raw = 0;
    for (int i = 0; i < hex_digits(L::kWidth); ++i) {
      const std::uint8_t digit = detail::kDigitValues[static_cast<std::uint8_t>(text[i])];
      bad |= digit;
      raw = (raw << 4) | (digit & 0xFU);
    }
    bad &= detail::kNoDigit;
    if constexpr (L::kWidth % 4 != 0) bad |= (raw >> L::kWidth) != 0 ? detail::kNoDigit : 0U;
    leaf = L::of_raw(raw);
    text += hex_digits(L::kWidth);
    if (--left > 0) bad |= *text++ != ' ' ? detail::kNoDigit : 0U;
  });
  return bad == 0;
}

template <class T>
void print_payload_text(const T& value, char* text) {
  bool first = true;
  rtl::visit_leaves(value, [&](const auto& leaf) {
    constexpr int kDigits = hex_digits(std::remove_cvref_t<decltype(leaf)>::kWidth);
    if (!first) *text++ = ' ';
    first = false;
    std::uint64_t raw = leaf.raw();
    for (int i = kDigits - 1; i >= 0; --i, raw >>= 4) text[i] = "0123456789ABCDEF"[raw & 0xF];
    text += kDigits;
  });
}

template <class T>
void pack_payload(const T& value, std::uint8_t* bytes) {
  constexpr int kWidth = rtl::payload_width<T>();
  std::memset(bytes, 0, (kWidth + 7) / 8);
  int bit = 0;
  rtl::visit_leaves(value, [&](const auto& leaf) {
    constexpr int kLeafWidth = std::remove_cvref_t<decltype(leaf)>::kWidth;
    detail::put_bits(bytes, bit, kLeafWidth, leaf.raw());
    bit += kLeafWidth;
  });
}

template <class T>
bool unpack_payload(const std::uint8_t* bytes, T& value) {
  int bit = 0;
  rtl::visit_leaves(value, [&](auto& leaf) {
    using L = std::remove_cvref_t<decltype(leaf)>;
    leaf = L::of_raw(detail::get_bits(bytes, bit, L::kWidth));
    bit += L::kWidth;
  });
  return bit % 8 == 0 || (bytes[bit / 8] >> (bit % 8)) == 0;
}

template <class T>
const PayloadCodec& payload_codec() {
  static_assert(std::is_trivially_copyable_v<T>);
  static const PayloadCodec codec{
      rtl::describe_leaves<T>(),
      static_cast<std::size_t>(rtl::payload_width<T>()),
      static_cast<std::size_t>(detail::text_length<T>()),
      sizeof(T),
      [](const char* text, void* payload) { return parse_payload_text(text, *static_cast<T*>(payload)); },
      [](const void* payload, char* text) { print_payload_text(*static_cast<const T*>(payload), text); },
      [](const void* payload, std::uint8_t* bytes) { pack_payload(*static_cast<const T*>(payload), bytes); },
      [](const std::uint8_t* bytes, void* payload) { return unpack_payload(bytes, *static_cast<T*>(payload)); }};
  return codec;
}

}  // namespace cbvh::vectors
