// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cassert>

#include "rtl_model/bits/sized.h"

/// The operators of the hardware: each costs gates, each result passes the hook, and none can overflow unnoticed.
namespace cbvh::rtl {

namespace detail {
constexpr std::uint64_t bits_of(std::int64_t value) { return static_cast<std::uint64_t>(value); }
}  // namespace detail

// Sums and differences, one bit wider than the wider operand; mixing kinds turns the unsigned one into a signed one
// first.

template <int A, int B, class H>
constexpr auto operator+(UInt<A, H> a, UInt<B, H> b) {
  return UInt<std::max(A, B) + 1, H>::of_result(a.raw() + b.raw());
}
template <int A, int B, class H>
constexpr auto operator+(SInt<A, H> a, SInt<B, H> b) {
  return SInt<std::max(A, B) + 1, H>::of_result(detail::bits_of(a.value() + b.value()));
}
template <int A, int B, class H>
constexpr auto operator+(SInt<A, H> a, UInt<B, H> b) {
  return a + SInt<B + 1, H>(b);
}
template <int A, int B, class H>
constexpr auto operator-(UInt<A, H> a, UInt<B, H> b) {
  return SInt<std::max(A, B) + 1, H>::of_result(a.raw() - b.raw());
}
template <int A, int B, class H>
constexpr auto operator-(SInt<A, H> a, SInt<B, H> b) {
  return SInt<std::max(A, B) + 1, H>::of_result(detail::bits_of(a.value() - b.value()));
}
template <int A, int B, class H>
constexpr auto operator-(SInt<A, H> a, UInt<B, H> b) {
  return a - SInt<B + 1, H>(b);
}

// Products, as wide as both operands together.

template <int A, int B, class H>
constexpr auto operator*(UInt<A, H> a, UInt<B, H> b) {
  return UInt<A + B, H>::of_result(a.raw() * b.raw());
}

// Bitwise, of one width.

template <int W, class H>
constexpr auto operator&(UInt<W, H> a, UInt<W, H> b) {
  return UInt<W, H>::of_result(a.raw() & b.raw());
}
template <int W, class H>
constexpr auto operator|(UInt<W, H> a, UInt<W, H> b) {
  return UInt<W, H>::of_result(a.raw() | b.raw());
}
template <int W, class H>
constexpr auto operator~(UInt<W, H> a) {
  return UInt<W, H>::of_result(~a.raw());
}

// Comparisons give one bit. They are functions, not operators: == of two wires is a bool that test benches use.

template <int A, int B, class H>
constexpr auto less(UInt<A, H> a, UInt<B, H> b) {
  return UInt<1, H>::of_result(a.raw() < b.raw());
}
template <int A, int B, class H>
constexpr auto less(SInt<A, H> a, SInt<B, H> b) {
  return UInt<1, H>::of_result(a.value() < b.value());
}
template <class A>
constexpr auto differ(A a, A b) {
  return UInt<1, typename A::HookType>::of_result(a.raw() != b.raw());
}
template <class A>
constexpr auto any(A a) {
  return UInt<1, typename A::HookType>::of_result(a.raw() != 0);
}
template <int W, class H>
constexpr auto negative(SInt<W, H> a) {
  return UInt<1, H>::of_result(a.raw() >> (W - 1));
}

/// The multiplexer. Both inputs have one type.
template <class T, class H>
constexpr T select(UInt<1, H> condition, T if_set, T if_clear) {
  return T::of_result(condition.raw() != 0 ? if_set.raw() : if_clear.raw());
}

// Shifts by a wire. Bits shifted out are lost on purpose; shifting by the width or more leaves only sign bits.

template <int W, int V, class H>
constexpr auto shift_right(UInt<W, H> a, UInt<V, H> distance) {
  return UInt<W, H>::of_result(distance.raw() >= static_cast<unsigned>(W) ? 0 : a.raw() >> distance.raw());
}
template <int W, int V, class H>
constexpr auto shift_right(SInt<W, H> a, UInt<V, H> distance) {
  const int bounded = static_cast<int>(std::min<std::uint64_t>(distance.raw(), W - 1));
  return SInt<W, H>::of_result(detail::bits_of(a.value() >> bounded));
}
template <int W, int V, class H>
constexpr auto shift_left(UInt<W, H> a, UInt<V, H> distance) {
  return UInt<W, H>::of_result(distance.raw() >= static_cast<unsigned>(W) ? 0 : a.raw() << distance.raw());
}
template <int W, int V, class H>
constexpr auto shift_left(SInt<W, H> a, UInt<V, H> distance) {
  return SInt<W, H>::of_result(distance.raw() >= static_cast<unsigned>(W) ? 0 : a.raw() << distance.raw());
}

/// Whether shift_right(a, distance) loses a set bit (the sticky bit).
template <int W, int V, class H>
constexpr auto dropped_bits(UInt<W, H> a, UInt<V, H> distance) {
  const int bounded = static_cast<int>(std::min<std::uint64_t>(distance.raw(), W));
  return UInt<1, H>::of_result((a.raw() & low_mask(bounded)) != 0);
}
template <int W, int V, class H>
constexpr auto dropped_bits(SInt<W, H> a, UInt<V, H> distance) {
  return dropped_bits(UInt<W, H>::of_raw(a.raw()), distance);
}

/// Zeros above the highest set bit; W for zero.
template <int W, class H>
constexpr auto count_leading_zeros(UInt<W, H> a) {
  return UInt<bits_for(W), H>::of_result(static_cast<std::uint64_t>(std::countl_zero(a.raw()) - (64 - W)));
}

/// floor(a / b), and below it a bit that is set when something remains. Of b = 0 all ones. A divider that gives a bit
/// of quotient a stage.
template <int A, int B, class H>
constexpr auto divide_with_sticky(UInt<A, H> a, UInt<B, H> b) {
  const std::uint64_t quotient = b.raw() == 0 ? low_mask(A) : a.raw() / b.raw();
  return UInt<A + 1, H>::of_result(quotient << 1 | (a.raw() != quotient * b.raw() ? 1u : 0u));
}

// Wiring: no gates, no hook.

template <int V, int W, class H>
requires(V <= W) constexpr auto truncate(UInt<W, H> a) { return UInt<V, H>::of_raw(a.raw()); }
template <int V, int W, class H>
requires(V <= W) constexpr auto truncate(SInt<W, H> a) { return SInt<V, H>::of_raw(a.raw()); }
/// Narrowing that must lose nothing: the design proves it, debug builds check it.
template <int V, int W, class H>
requires(V <= W) constexpr auto checked(SInt<W, H> a) {
  assert(a.value() == sign_extend(a.raw(), V));
  return SInt<V, H>::of_raw(a.raw());
}
template <int V, int W, class H>
requires(V <= W) constexpr auto checked(UInt<W, H> a) {
  assert(a.raw() <= low_mask(V));
  return UInt<V, H>::of_raw(a.raw());
}
/// The low V bits of a two's complement value, read as unsigned: the value modulo 2^V.
template <int V, int W, class H>
requires(V <= W) constexpr auto modulo_bits(SInt<W, H> a) { return UInt<V, H>::of_raw(a.raw()); }
template <int High, int Low, int W, class H>
requires(High < W && Low <= High) constexpr auto bits(UInt<W, H> a) {
  return UInt<High - Low + 1, H>::of_raw(a.raw() >> Low);
}
template <int A, int B, class H>
constexpr auto concat(UInt<A, H> high, UInt<B, H> low) {
  return UInt<A + B, H>::of_raw(high.raw() << B | low.raw());
}
template <int W, class H>
constexpr auto as_signed(UInt<W, H> a) {
  return SInt<W + 1, H>(a);
}
/// Bit i of a at place 3 i, zeros between.
template <int W, class H>
requires(W <= 10) constexpr auto spread_by_three(UInt<W, H> a) {
  std::uint64_t x = a.raw();
  x = (x | x << 16) & 0x030000FF;
  x = (x | x << 8) & 0x0300F00F;
  x = (x | x << 4) & 0x030C30C3;
  x = (x | x << 2) & 0x09249249;
  return UInt<3 * W - 2, H>::of_raw(x);
}

}  // namespace cbvh::rtl
