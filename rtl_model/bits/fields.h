// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <tuple>
#include <type_traits>
#include <vector>

#include "rtl_model/bits/float32.h"
#include "rtl_model/bits/sized.h"

/// A payload lists its fields once, in `fields()`; everything that prints, parses, packs, traces or compares it goes
/// through here.
namespace cbvh::rtl {

template <class Payload, class Member>
struct Field {
  const char* name;
  Member Payload::*member;
};

namespace detail {
template <class Payload, class Member, class... Rest>
constexpr auto field_tuple(const char* name, Member Payload::*member, Rest... rest) {
  if constexpr (sizeof...(Rest) == 0) {
    return std::make_tuple(Field<Payload, Member>{name, member});
  } else {
    return std::tuple_cat(std::make_tuple(Field<Payload, Member>{name, member}), field_tuple(rest...));
  }
}
}  // namespace detail

/// field_list("lower", &AxisJob::lower, "upper", &AxisJob::upper, ...)
template <class... NamesAndMembers>
constexpr auto field_list(NamesAndMembers... names_and_members) {
  return detail::field_tuple(names_and_members...);
}

/// A field that is itself bits: UInt, SInt or Float32.
template <class T>
concept Leaf = Wire<std::remove_const_t<T>> || std::is_same_v<std::remove_const_t<T>, Float32>;

template <class T>
concept Payload = requires {
  std::remove_const_t<T>::fields();
};

namespace detail {
template <class T>
struct IsArray : std::false_type {};
template <class T, std::size_t Size>
struct IsArray<std::array<T, Size>> : std::true_type {};

/// Elements of an array of three are the axes x, y, z; of any other array 0, 1, ...
template <std::size_t Size>
std::string element_name(std::size_t index) {
  return Size == 3 ? std::string(1, static_cast<char>('x' + index)) : std::to_string(index);
}

inline std::string joined(std::string path, const std::string& name) {
  if (!path.empty()) path += '_';
  path += name;
  return path;
}
}  // namespace detail

/// Calls visit(leaf) for every leaf of the payload, in the order of the field lists. Nested payloads and arrays are
/// walked.
template <class T, class Visit>
constexpr void visit_leaves(T& value, Visit&& visit) {
  if constexpr (Leaf<T>) {
    visit(value);
  } else if constexpr (detail::IsArray<std::remove_const_t<T>>::value) {
    for (auto& element : value) visit_leaves(element, visit);
  } else {
    std::apply([&](auto... field) { (visit_leaves(value.*field.member, visit), ...); },
               std::remove_const_t<T>::fields());
  }
}

/// Calls visit(name, leaf) for every leaf; a nested leaf's name joins the path with '_', as the Verilog port is called.
template <class T, class Visit>
void visit_named_leaves(T& value, Visit&& visit, const std::string& path = {}) {
  if constexpr (Leaf<T>) {
    visit(path, value);
  } else if constexpr (detail::IsArray<std::remove_const_t<T>>::value) {
    std::size_t index = 0;
    for (auto& element : value) {
      const auto name = detail::element_name<std::tuple_size_v<std::remove_const_t<T>>>(index++);
      visit_named_leaves(element, visit, detail::joined(path, name));
    }
  } else {
    std::apply(
        [&](auto... field) { (visit_named_leaves(value.*field.member, visit, detail::joined(path, field.name)), ...); },
        std::remove_const_t<T>::fields());
  }
}

/// What a format needs to know of one leaf.
struct LeafDescription {
  enum class Kind { unsigned_integer, signed_integer, binary32 };
  std::string name;
  int width;
  Kind kind;
};

/// The leaves of a payload type, in order.
template <class T>
std::vector<LeafDescription> describe_leaves() {
  std::vector<LeafDescription> leaves;
  T value{};
  visit_named_leaves(value, [&](const std::string& name, auto& leaf) {
    using L = std::remove_reference_t<decltype(leaf)>;
    auto kind = LeafDescription::Kind::binary32;
    if constexpr (Wire<L>) {
      kind = L::kSigned ? LeafDescription::Kind::signed_integer : LeafDescription::Kind::unsigned_integer;
    }
    leaves.push_back({name, L::kWidth, kind});
  });
  return leaves;
}

/// The number of bits of a payload.
template <class T>
constexpr int payload_width() {
  int width = 0;
  T value{};
  visit_leaves(value, [&](const auto& leaf) { width += std::remove_cvref_t<decltype(leaf)>::kWidth; });
  return width;
}

}  // namespace cbvh::rtl
