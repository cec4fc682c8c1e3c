// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_model/datapath/codes.h"

namespace cbvh::rtl {

/// A stored pair after one backtracking step, and the contexts its children had and have.
template <int N>
struct Reencoded {
  NodePair<N> pair;
  std::array<Context, 2> child_before;
  std::array<Context, 2> child_after;
  std::array<UInt<1>, 2> repair;  ///< the child is a pair, and its context change invalidates it
};

/// The context of a child that occupies these cells of a grid. Rule 4.
template <class Bits, int N>
constexpr AxisContext context_of_cells(CellPair<Bits> cells, typename Bits::template S<kScaleBits> scale,
                                       const SceneRegisters& registers) {
  const auto difference = modulo_bits<N>(modulo_bits<N>(cells.upper - cells.lower) - constant<Bits, 1>(1));
  const auto own = own_grid<Bits>(scale, cells.lower, refinement<Bits, N>(difference, lift<Bits>(registers.figure5)),
                                  lift<Bits>(registers.min_scale));
  return {lower(own.scale), lower(own.lower)};
}

/// Decodes a stored pair with the context it was written with and encodes it for another. Paper algorithm 1, function
/// Backtrack, on cell indices instead of floats.
template <class Bits, int N>
constexpr Reencoded<N> reencode(const NodePair<N>& stored, const Context& before, const Context& after,
                                const SceneRegisters& registers) {
  [[maybe_unused]] const typename Bits::Scope scope(Datapath::reencode);
  Reencoded<N> result{stored, {}, {}, {}};
  const auto relative = lift<Bits>(registers.relative);
  for (std::size_t child = 0; child < 2; ++child) {
    auto& codes = result.pair.child[child];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto old_scale = lift<Bits>(before[axis].scale);
      const auto new_scale = lift<Bits>(after[axis].scale);
      const auto new_lower = lift<Bits>(after[axis].lower);
      const auto old_cells = decode_codes<Bits, N>(lift<Bits>(codes.lo[axis]), lift<Bits>(codes.hi[axis]),
                                                   lift<Bits>(before[axis].lower), relative);
      const auto new_cells = coarsen<Bits>(old_cells, modulo_bits<5>(new_scale - old_scale));
      codes.lo[axis] = lower(store_code<Bits, N>(modulo_bits<N>(new_cells.lower), new_lower, relative));
      codes.hi[axis] = lower(store_code<Bits, N>(modulo_bits<N>(new_cells.upper), new_lower, relative));
      result.child_before[child][axis] = context_of_cells<Bits, N>(old_cells, old_scale, registers);
      result.child_after[child][axis] = context_of_cells<Bits, N>(new_cells, new_scale, registers);
    }
    const auto changed = invalidates<Bits>(result.child_before[child], result.child_after[child], relative);
    result.repair[child] = lower(changed & ~lift<Bits>(codes.leaf));
  }
  return result;
}

}  // namespace cbvh::rtl
