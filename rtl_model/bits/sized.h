// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cassert>
#include <compare>
#include <cstdint>
#include <type_traits>

namespace cbvh::rtl {

/// What happens to the result of every operation: nothing. A test's hook may count results or spoil one of them.
struct NoHook {
  template <int W>
  static constexpr std::uint64_t result(std::uint64_t raw) {
    return raw;
  }
};

constexpr std::uint64_t low_mask(int width) {
  return width >= 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << width) - 1;
}

constexpr std::int64_t sign_extend(std::uint64_t raw, int width) {
  const int unused = 64 - width;
  return static_cast<std::int64_t>(raw << unused) >> unused;
}

/// The number of bits that hold every value from 0 to `largest`.
constexpr int bits_for(std::uint64_t largest) { return largest == 0 ? 1 : static_cast<int>(std::bit_width(largest)); }

template <int W>
using Storage = std::conditional_t<
    W <= 8, std::uint8_t,
    std::conditional_t<W <= 16, std::uint16_t, std::conditional_t<W <= 32, std::uint32_t, std::uint64_t>>>;

/// An unsigned wire or register of W bits. Operations grow their result so that nothing is lost; narrowing is a named
/// word.
template <int W, class Hook = NoHook>
class UInt {
  static_assert(W >= 1 && W <= 64);

 public:
  static constexpr int kWidth = W;
  static constexpr bool kSigned = false;
  using HookType = Hook;

  constexpr UInt() = default;
  constexpr explicit UInt(std::uint64_t value) : raw_(static_cast<Storage<W>>(value)) { assert(value <= low_mask(W)); }
  template <int V>
  requires(V < W) constexpr UInt(UInt<V, Hook> narrower) : raw_(static_cast<Storage<W>>(narrower.raw())) {}

  /// The low W bits of `raw`, as an operation of the hardware produced them.
  static constexpr UInt of_result(std::uint64_t raw) { return of_raw(Hook::template result<W>(raw & low_mask(W))); }
  /// The low W bits of `raw`, as they were stored.
  static constexpr UInt of_raw(std::uint64_t raw) {
    UInt wire;
    wire.raw_ = static_cast<Storage<W>>(raw & low_mask(W));
    return wire;
  }

  constexpr std::uint64_t raw() const { return raw_; }
  constexpr std::uint64_t value() const { return raw_; }
  constexpr explicit operator bool() const requires(W == 1) { return raw_ != 0; }
  constexpr bool operator==(const UInt&) const = default;

 private:
  Storage<W> raw_ = 0;
};

/// A two's complement wire or register of W bits. Operations grow their result so that nothing is lost; narrowing is a
/// named word.
template <int W, class Hook = NoHook>
class SInt {
  static_assert(W >= 1 && W <= 64);

 public:
  static constexpr int kWidth = W;
  static constexpr bool kSigned = true;
  using HookType = Hook;

  constexpr SInt() = default;
  constexpr explicit SInt(std::int64_t value) : SInt(of_raw(static_cast<std::uint64_t>(value))) {
    assert(this->value() == value);
  }
  template <int V>
  requires(V < W) constexpr SInt(SInt<V, Hook> narrower) : SInt(of_raw(static_cast<std::uint64_t>(narrower.value()))) {}
  template <int V>
  requires(V < W) constexpr SInt(UInt<V, Hook> narrower) : SInt(of_raw(narrower.raw())) {}

  static constexpr SInt of_result(std::uint64_t raw) { return of_raw(Hook::template result<W>(raw & low_mask(W))); }
  static constexpr SInt of_raw(std::uint64_t raw) {
    SInt wire;
    wire.raw_ = static_cast<Storage<W>>(raw & low_mask(W));
    return wire;
  }

  constexpr std::uint64_t raw() const { return raw_; }
  constexpr std::int64_t value() const { return sign_extend(raw_, W); }
  constexpr bool operator==(const SInt&) const = default;

 private:
  Storage<W> raw_ = 0;
};

template <class T>
struct IsWire : std::false_type {};
template <int W, class H>
struct IsWire<UInt<W, H>> : std::true_type {};
template <int W, class H>
struct IsWire<SInt<W, H>> : std::true_type {};

/// A sized integer of either kind.
template <class T>
concept Wire = IsWire<T>::value;

}  // namespace cbvh::rtl
