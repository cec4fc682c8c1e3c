// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_model/datapath/codes.h"
#include "rtl_model/datapath/scale_estimate.h"

namespace cbvh::rtl {

/// The box that encloses both children on one axis.
template <class Bits>
constexpr EstimateJob union_axis(const FloatPair& pair, std::size_t axis, const SceneRegisters& registers) {
  [[maybe_unused]] const typename Bits::Scope scope(Datapath::union_axis);
  const auto& [left, right] = pair.box;
  return {lower_float(smaller_float<Bits>(lift<Bits>(left.lower[axis]), lift<Bits>(right.lower[axis]))),
          lower_float(larger_float<Bits>(lift<Bits>(left.upper[axis]), lift<Bits>(right.upper[axis]))), registers};
}

/// Of two reasons to refuse, the one with the lower number.
template <class Bits>
constexpr auto first_reason(typename Bits::template U<3> a, typename Bits::template U<3> b) {
  return select(any(a) & (less(a, b) | ~any(b)), a, b);
}

/// The context a pair is compressed with: the given one, or the estimate of its three axes.
template <class Bits>
constexpr Context choose_context(const PairJob& job, const std::array<EstimateResult, 3>& estimates) {
  [[maybe_unused]] const typename Bits::Scope scope(Datapath::choose_context);
  const auto given = lift<Bits>(job.given_context);
  Context context;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    context[axis] = {lower(select(given, lift<Bits>(job.context[axis].scale), lift<Bits>(estimates[axis].scale))),
                     lower(select(given, lift<Bits>(job.context[axis].lower), lift<Bits>(estimates[axis].lower)))};
  }
  return context;
}

constexpr AxisJob axis_job(const PairJob& job, const Context& context, std::size_t child, std::size_t axis) {
  return {job.pair.box[child].lower[axis], job.pair.box[child].upper[axis], context[axis].scale, job.registers};
}

/// Puts six compressed axes together. One refused axis refuses the pair.
template <class Bits, int N>
constexpr PairResult<N> assemble_pair(const PairJob& job, const Context& context,
                                      const std::array<std::array<AxisResult<N>, 3>, 2>& axes) {
  [[maybe_unused]] const typename Bits::Scope scope(Datapath::assemble_pair);
  auto status = lift<Bits>(StatusBits());
  for (const auto& child : axes) {
    for (const auto& axis : child) status = first_reason<Bits>(status, lift<Bits>(axis.status));
  }
  const auto refused = any(status);
  const auto gate = [&](auto wire) { return lower(select(refused, decltype(wire)(), wire)); };
  const auto relative = lift<Bits>(job.registers.relative);
  PairResult<N> result;
  result.status = lower(status);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    result.context[axis] = {gate(lift<Bits>(context[axis].scale)), gate(lift<Bits>(context[axis].lower))};
  }
  for (std::size_t child = 0; child < 2; ++child) {
    auto& codes = result.pair.child[child];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto& compressed = axes[child][axis];
      const auto parent_lower = lift<Bits>(context[axis].lower);
      codes.lo[axis] = gate(store_code<Bits, N>(lift<Bits>(compressed.code_lo), parent_lower, relative));
      codes.hi[axis] = gate(store_code<Bits, N>(lift<Bits>(compressed.code_hi), parent_lower, relative));
      result.child_context[child][axis] = {gate(lift<Bits>(compressed.own_scale)),
                                           gate(lift<Bits>(compressed.own_lower))};
    }
    codes.leaf = gate(lift<Bits>(job.pair.leaf[child]));
    codes.pointer = gate(lift<Bits>(job.pair.pointer[child]));
  }
  return result;
}

/// A whole node pair: three estimates, six axes. Paper section 4.2.1.
template <class Bits, int N>
constexpr PairResult<N> compress_pair(const PairJob& job) {
  std::array<EstimateResult, 3> estimates;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    estimates[axis] = estimate_scale<Bits, N>(union_axis<Bits>(job.pair, axis, job.registers));
  }
  const Context context = choose_context<Bits>(job, estimates);
  std::array<std::array<AxisResult<N>, 3>, 2> axes;
  for (std::size_t child = 0; child < 2; ++child) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      axes[child][axis] = compress_axis<Bits, N>(axis_job(job, context, child, axis));
    }
  }
  return assemble_pair<Bits, N>(job, context, axes);
}

}  // namespace cbvh::rtl
