// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_model/bits/corner.h"
#include "rtl_model/bits/float32.h"
#include "rtl_model/bits/operations.h"

namespace cbvh::rtl {

/// The bit type that simulates on machine integers. Datapaths and modules are templates over a type of this shape.
struct MachineBits {
  using Hook = NoHook;
  template <int W>
  using U = UInt<W, Hook>;
  template <int W>
  using S = SInt<W, Hook>;
  using F = U<32>;  ///< a binary32, as its bits

  /// Alive while a datapath function is being evaluated.
  struct Scope {
    constexpr explicit Scope(Datapath) {}
  };
  /// Announces a corner of the design; returns whether it is taken.
  static constexpr U<1> corner(Corner, U<1> taken) { return taken; }
};

/// From a payload's plain bits to those of `Bits`, and back.
template <class Bits, int W>
constexpr auto lift(UInt<W> plain) {
  return typename Bits::template U<W>(Bits::template U<W>::of_raw(plain.raw()));
}
template <class Bits, int W>
constexpr auto lift(SInt<W> plain) {
  return typename Bits::template S<W>(Bits::template S<W>::of_raw(plain.raw()));
}
template <class Bits>
constexpr auto lift(Float32 plain) {
  return Bits::F::of_raw(plain.bits);
}
template <int W, class H>
constexpr auto lower(UInt<W, H> wire) {
  return UInt<W>::of_raw(wire.raw());
}
template <int W, class H>
constexpr auto lower(SInt<W, H> wire) {
  return SInt<W>::of_raw(wire.raw());
}
template <class H>
constexpr Float32 lower_float(UInt<32, H> wire) {
  return Float32::of_raw(wire.raw());
}

/// A corner of control logic, as the condition of an `if`.
template <class Bits>
constexpr bool taken(Corner corner, bool condition) {
  return bool(Bits::corner(corner, Bits::template U<1>::of_raw(condition)));
}

/// A literal: U<5> of 24 is constant<Bits, 5>(24).
template <class Bits, int W>
constexpr auto constant(std::uint64_t value) {
  return Bits::template U<W>::of_raw(value);
}

}  // namespace cbvh::rtl
