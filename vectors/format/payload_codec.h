// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <type_traits>
#include <utility>
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

template <class T>
constexpr int leaf_count() {
  int count = 0;
  T value{};
  rtl::visit_leaves(value, [&](const auto&) { ++count; });
  return count;
}

/// The name of an element of an array, as rtl::visit_named_leaves has it.
std::string element_path(const std::string& path, std::size_t size, std::size_t index);
std::string field_path(const std::string& path, const char* name);

}  // namespace detail

/// One leaf of a payload, and where it lies in the object.
struct CodecLeaf : rtl::LeafDescription {
  std::size_t offset;  ///< bytes
  std::size_t size;    ///< bytes: 1, 2, 4 or 8; its raw bits, zero above the width
};

/// What the formats need to know of a payload type. Most of it is a table, so that the many payloads of many widths
/// compile fast. Functions take the object's address.
class PayloadCodec {
 public:
  using Parse = bool (*)(const char* text, void* payload);

  /// `parse` is used instead of the table where it is not null.
  PayloadCodec(std::vector<CodecLeaf> leaf_table, std::size_t size, Parse parse);

  const std::vector<CodecLeaf> leaves;  ///< in order
  const std::size_t width;              ///< bits
  const std::size_t text_length;        ///< hex digits of all leaves, with a blank between two
  const std::size_t object_size;        ///< sizeof the type, which is trivially copyable

  std::size_t packed_bytes() const { return (width + 7) / 8; }
  /// The names of the leaves, joined by ':'.
  std::string field_names() const;

  /// Reads exactly text_length characters; false when a character is not what it must be or a value does not fit its
  /// field. Then the object's content is arbitrary.
  bool parse_text(const char* text, void* payload) const {
    return parse_ != nullptr ? parse_(text, payload) : parse_by_table(text, payload);
  }
  bool parse_by_table(const char* text, void* payload) const;
  /// Writes exactly text_length characters.
  void print_text(const void* payload, char* text) const;
  /// First leaf in the lowest bits; packed_bytes() bytes, padding zero.
  void pack(const void* payload, std::uint8_t* bytes) const;
  /// False when a padding bit is set.
  bool unpack(const std::uint8_t* bytes, void* payload) const;

 private:
  Parse parse_;
};

namespace detail {

/// Adds the leaves of `value`, which lies in the object at `base`.
template <class T>
void list_leaves(const T& value, const char* base, const std::string& path, std::vector<CodecLeaf>& leaves) {
  if constexpr (rtl::Leaf<T>) {
    auto kind = rtl::LeafDescription::Kind::binary32;
    if constexpr (rtl::Wire<T>) {
      kind = T::kSigned ? rtl::LeafDescription::Kind::signed_integer : rtl::LeafDescription::Kind::unsigned_integer;
    }
    static_assert(std::is_trivially_copyable_v<T> && sizeof(T) == sizeof(rtl::Storage<T::kWidth>));
    leaves.push_back(
        {{path, T::kWidth, kind}, static_cast<std::size_t>(reinterpret_cast<const char*>(&value) - base), sizeof(T)});
  } else if constexpr (rtl::detail::IsArray<T>::value) {
    for (std::size_t i = 0; i < value.size(); ++i) {
      list_leaves(value[i], base, element_path(path, value.size(), i), leaves);
    }
  } else {
    std::apply(
        [&](auto... field) { (list_leaves(value.*field.member, base, field_path(path, field.name), leaves), ...); },
        T::fields());
  }
}

/// The same as PayloadCodec::parse_by_table, with all widths known to the compiler.
template <class T>
bool parse_by_type(const char* text, T& value) {
  unsigned bad = 0;
  int left = leaf_count<T>();
  rtl::visit_leaves(value, [&](auto& leaf) {
    using L = std::remove_cvref_t<decltype(leaf)>;
    std::uint64_t raw = 0;
    for (int i = 0; i < hex_digits(L::kWidth); ++i) {
      const std::uint8_t digit = kDigitValues[static_cast<std::uint8_t>(text[i])];
      bad |= digit;
      raw = (raw << 4) | (digit & 0xFU);
    }
    bad &= kNoDigit;
    if constexpr (L::kWidth % 4 != 0) bad |= (raw >> L::kWidth) != 0 ? kNoDigit : 0U;
    leaf = L::of_raw(raw);
    text += hex_digits(L::kWidth);
    if (--left > 0) bad |= *text++ != ' ' ? kNoDigit : 0U;
  });
  return bad == 0;
}

/// Payloads of few leaves come in files of millions of lines.
template <class T>
constexpr PayloadCodec::Parse parser_of() {
  constexpr int kFewLeaves = 8;
  if constexpr (leaf_count<T>() <= kFewLeaves) {
    return [](const char* text, void* payload) { return parse_by_type(text, *static_cast<T*>(payload)); };
  } else {
    return nullptr;
  }
}

}  // namespace detail

template <class T>
const PayloadCodec& payload_codec() {
  static_assert(std::is_trivially_copyable_v<T>);
  static const PayloadCodec codec = [] {
    const T value{};
    std::vector<CodecLeaf> leaves;
    detail::list_leaves(value, reinterpret_cast<const char*>(&value), {}, leaves);
    return PayloadCodec(std::move(leaves), sizeof(T), detail::parser_of<T>());
  }();
  return codec;
}

}  // namespace cbvh::vectors
