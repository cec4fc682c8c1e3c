// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>

#include "golden/tree/compressed_tree.h"
#include "vectors/faces/axis.h"

/// The golden's answer for a pair of siblings, in plain numbers.
namespace cbvh::vectors {

struct PairAnswer {
  rtl::Status status = rtl::Status::ok;
  golden::Context<Index> context{};                    ///< the one the pair is compressed with
  std::array<std::array<Cells<Index>, 3>, 2> cells{};  ///< [child][axis]
  std::array<golden::Context<Index>, 2> child_context{};
};

/// The box around both children, per axis. Only for boxes that are valid.
golden::Box union_box(const rtl::FloatPair& pair);

/// The pair on the given context, or on the estimate (rule 6). When refused, everything but the status is zero; the
/// status is the smallest that refuses one of the six axes.
PairAnswer compress_pair(const rtl::FloatPair& pair, const std::optional<golden::Context<Index>>& given,
                         const rtl::SceneRegisters& registers, int bits);

/// The stored form of a pair that was not refused: rule 5, relative to or modulo the context's lower indices.
golden::CompressedPair stored_pair(const rtl::FloatPair& pair, const PairAnswer& answer,
                                   const rtl::SceneRegisters& registers, int bits);

template <int N>
rtl::NodePair<N> to_wires(const golden::CompressedPair& pair) {
  rtl::NodePair<N> wires;
  for (std::size_t c = 0; c < 2; ++c) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      wires.child[c].lo[axis] = rtl::UInt<N>(pair.child[c].codes[axis].lower);
      wires.child[c].hi[axis] = rtl::UInt<N>(pair.child[c].codes[axis].upper);
    }
    wires.child[c].leaf = rtl::UInt<1>(pair.child[c].leaf);
    wires.child[c].pointer = rtl::Pointer(pair.child[c].pointer);
  }
  return wires;
}

template <int N>
golden::CompressedPair from_wires(const rtl::NodePair<N>& wires) {
  golden::CompressedPair pair{};
  for (std::size_t c = 0; c < 2; ++c) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      pair.child[c].codes[axis] = {static_cast<std::uint8_t>(wires.child[c].lo[axis].raw()),
                                   static_cast<std::uint8_t>(wires.child[c].hi[axis].raw())};
    }
    pair.child[c].leaf = bool(wires.child[c].leaf);
    pair.child[c].pointer = static_cast<std::uint32_t>(wires.child[c].pointer.raw());
  }
  return pair;
}

/// Rule 9: must a child that was written with the context `before` be re-encoded when its context is `after`?
bool is_invalidated(const golden::Context<Index>& before, const golden::Context<Index>& after, golden::Code code);

}  // namespace cbvh::vectors
