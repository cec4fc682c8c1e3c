// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>

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

/// The stored form of cells: rule 5, relative to or modulo the context's lower indices.
template <int N>
rtl::NodeCodes<N> store_codes(const std::array<Cells<Index>, 3>& cells, const golden::Context<Index>& context,
                              rtl::UInt<1> leaf, rtl::Pointer pointer, golden::Code code) {
  rtl::NodeCodes<N> codes;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const golden::AxisCodes stored = golden::encode_codes(cells[axis], context[axis].lower, code, N);
    codes.lo[axis] = rtl::UInt<N>(stored.lower);
    codes.hi[axis] = rtl::UInt<N>(stored.upper);
  }
  codes.leaf = leaf;
  codes.pointer = pointer;
  return codes;
}

/// Of a pair that was not refused.
template <int N>
rtl::NodePair<N> store_pair(const rtl::FloatPair& pair, const PairAnswer& answer, golden::Code code) {
  rtl::NodePair<N> stored;
  for (std::size_t child = 0; child < 2; ++child) {
    stored.child[child] =
        store_codes<N>(answer.cells[child], answer.context, pair.leaf[child], pair.pointer[child], code);
  }
  return stored;
}

/// Rule 9: must a child that was written with the context `before` be re-encoded when its context is `after`?
bool is_invalidated(const golden::Context<Index>& before, const golden::Context<Index>& after, golden::Code code);

}  // namespace cbvh::vectors
