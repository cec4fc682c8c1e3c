// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_model/datapath/codes.h"
#include "rtl_model/datapath/pair_compress.h"
#include "rtl_model/datapath/traverse_payloads.h"

namespace cbvh::rtl {

/// Whether an index lies outside -2^24..2^24, where an edge need not be a float.
template <class Bits, int W>
constexpr auto beyond_exact_indices(SInt<W, typename Bits::Hook> index) {
  const auto above_lowest = index + constant<Bits, 25>(1u << 24);
  return negative(above_lowest) | less(as_signed(constant<Bits, 26>(1u << 25)), above_lowest);
}

/// One axis of a decoded child.
template <class Bits>
struct DecodedAxis {
  CellPair<Bits> cells;  ///< on the parent's own grid
  OwnGrid<Bits> own;
  typename Bits::template U<3> status;
};

/// Paper fig. 4 along one axis, with the errata of DESIGN 3.1 corrected: the condition of equation 9 in decode_codes,
/// the loop's end in refinement. Codes and contexts that no compressor makes are refused.
template <class Bits, int N>
constexpr DecodedAxis<Bits> decode_axis(typename Bits::template U<N> lo, typename Bits::template U<N> hi,
                                        typename Bits::template S<kScaleBits> scale,
                                        typename Bits::template S<kIndexBits> parent_lower,
                                        const SceneRegisters& registers) {
  using Wide = typename Bits::template S<kIndexBits + N>;
  const auto min_scale = lift<Bits>(registers.min_scale);
  const auto figure5 = lift<Bits>(registers.figure5);
  const auto cells = decode_codes<Bits, N>(lo, hi, parent_lower, lift<Bits>(registers.relative));
  // The number of cells, less one, is right even if the indices left their range: N + 1 bits and a sign hold it.
  const auto difference = truncate<N + 2>(truncate<N + 2>(cells.upper - cells.lower) - constant<Bits, 1>(1));
  const auto own =
      own_grid<Bits>(scale, cells.lower, refinement<Bits, N>(modulo_bits<N>(difference), figure5), min_scale);
  const auto unclipped_own_lower = shift_left(Wide(cells.lower), modulo_bits<4>(scale - own.scale));

  const auto inverted = Bits::corner(Corner::decode_inverted, negative(difference));
  const auto below = Bits::corner(Corner::decode_scale_below_minimum, less(scale, min_scale));
  const auto wide =
      Bits::corner(Corner::decode_too_wide, less(as_signed(largest_difference<Bits, N>(figure5)), difference));
  const auto own_beyond = beyond_exact_indices<Bits>(unclipped_own_lower) & ~below & ~wide;
  const auto finer_than_floats =
      less(min_scale, Bits::template S<kScaleBits>::of_raw(static_cast<std::uint64_t>(-149)));
  const auto inexact =
      Bits::corner(Corner::decode_beyond_exactness, finer_than_floats | beyond_exact_indices<Bits>(cells.lower) |
                                                        beyond_exact_indices<Bits>(cells.upper) | own_beyond);
  const auto status_of = [](Status status) { return constant<Bits, 3>(static_cast<std::uint64_t>(status)); };
  const auto status = select(inverted, status_of(Status::inverted),
                             select(inexact, status_of(Status::beyond_exactness),
                                    select(below, status_of(Status::scale_below_minimum),
                                           select(wide, status_of(Status::too_wide), status_of(Status::ok)))));
  return {cells, own, status};
}

/// A stored child with its parent's context: its box in binary32 and its own context. One refused axis refuses the
/// child.
template <class Bits, int N>
constexpr DecodeResult decode_box(const DecodeJob<N>& job) {
  [[maybe_unused]] const typename Bits::Scope scope(Datapath::decode_box);
  std::array<DecodedAxis<Bits>, 3> axes;
  auto status = lift<Bits>(StatusBits());
  for (std::size_t axis = 0; axis < 3; ++axis) {
    axes[axis] =
        decode_axis<Bits, N>(lift<Bits>(job.node.lo[axis]), lift<Bits>(job.node.hi[axis]),
                             lift<Bits>(job.parent[axis].scale), lift<Bits>(job.parent[axis].lower), job.registers);
    status = first_reason<Bits>(status, axes[axis].status);
  }
  const auto refused = any(status);
  const auto gate = [&](auto wire) { return select(refused, decltype(wire)(), wire); };
  DecodeResult result;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto& [cells, own, axis_status] = axes[axis];
    const auto scale = lift<Bits>(job.parent[axis].scale);
    result.box.lower[axis] = lower_float(pack_float<Bits>(gate(cells.lower), scale));
    result.box.upper[axis] = lower_float(pack_float<Bits>(gate(cells.upper), scale));
    result.context[axis] = {lower(gate(own.scale)), lower(gate(own.lower))};
  }
  result.leaf = lower(gate(lift<Bits>(job.node.leaf)));
  result.pointer = lower(gate(lift<Bits>(job.node.pointer)));
  result.status = lower(status);
  return result;
}

}  // namespace cbvh::rtl
