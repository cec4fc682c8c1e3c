// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_model/datapath/cell_index.h"
#include "rtl_model/datapath/directed_float.h"
#include "rtl_model/datapath/pair_compress.h"
#include "rtl_model/datapath/ray_payloads.h"

namespace cbvh::rtl {

/// One axis of a child, as its parent's codes say it.
template <class Bits, int N>
struct ChildAxis {
  typename Bits::template U<N + 1> from_lower;  ///< cells between the lower planes of parent and child
  typename Bits::template U<N + 1> from_upper;  ///< cells between their upper planes
  typename Bits::template S<kScaleBits> scale;  ///< of the child's own grid
  typename Bits::template U<N> lower;
  typename Bits::template U<N + 1> cells;
  typename Bits::template U<3> status;
};

/// Equations 5 and 9 ask for the codes' distances from the parent's planes alone, so N bits of its lower index are
/// enough.
template <class Bits, int N>
constexpr ChildAxis<Bits, N> child_axis(typename Bits::template U<N> lo, typename Bits::template U<N> hi,
                                        const GridAxis<N>& parent, const SceneRegisters& registers) {
  using Cells = typename Bits::template U<N + 1>;
  const auto scale = lift<Bits>(parent.scale);
  const auto lower_index = lift<Bits>(parent.lower);
  const auto parent_cells = lift<Bits>(parent.cells);
  const auto min_scale = lift<Bits>(registers.min_scale);
  const auto figure5 = lift<Bits>(registers.figure5);
  const auto base = select(lift<Bits>(registers.relative), constant<Bits, N>(0), lower_index);
  const auto r = modulo_bits<N>(lo - base);
  const auto s_modulo = modulo_bits<N>(hi - base);
  const auto s = concat(Bits::corner(Corner::ray_full_span, ~any(s_modulo)), s_modulo);
  const auto difference = s - r - constant<Bits, 1>(1);
  const auto rest = parent_cells - s;
  const auto own = own_grid<Bits>(scale, typename Bits::template S<kIndexBits>(),
                                  refinement<Bits, N>(modulo_bits<N>(difference), figure5), min_scale);
  const auto finer = modulo_bits<4>(scale - own.scale);
  const auto own_lower = truncate<N>(lower_index + r);

  const auto status_of = [](Status status) { return constant<Bits, 3>(static_cast<std::uint64_t>(status)); };
  const auto inverted = Bits::corner(Corner::ray_inverted, negative(difference));
  const auto below = Bits::corner(Corner::ray_scale_below_minimum, less(scale, min_scale));
  const auto wide = Bits::corner(Corner::ray_too_wide,
                                 negative(rest) | less(as_signed(largest_difference<Bits, N>(figure5)), difference));
  const auto status = select(inverted, status_of(Status::inverted),
                             select(below, status_of(Status::scale_below_minimum),
                                    select(wide, status_of(Status::too_wide), status_of(Status::ok))));
  return {Cells(r),
          modulo_bits<N + 1>(rest),
          own.scale,
          shift_left(own_lower, finer),
          shift_left(modulo_bits<N + 1>(s - r), finer),
          status};
}

/// The child's planes on one axis, from the parent's: towards each other, each rounded away from the other.
template <class Bits, int N>
constexpr PlaneDistances child_planes(const ChildAxis<Bits, N>& child, const GridAxis<N>& parent,
                                      const PlaneDistances& planes, const RayAxis& ray) {
  const auto backwards = lift<Bits>(ray.backwards);
  const auto inverse = break_float<Bits>(lift<Bits>(ray.inverse));
  const auto scale = lift<Bits>(parent.scale);
  const auto to_near = select(backwards, child.from_upper, child.from_lower);
  const auto to_far = select(backwards, child.from_lower, child.from_upper);
  const auto near = advance_down<Bits>(lift<Bits>(planes.near), to_near, inverse, scale);
  const auto far = advance_down<Bits>(negate_float<Bits>(lift<Bits>(planes.far)), to_far, inverse, scale);
  return {lower_float(near), lower_float(negate_float<Bits>(far))};
}

/// Where the ray is inside all planes.
template <class Bits>
struct RayInterval {
  typename Bits::F entry;
  typename Bits::F exit;
  typename Bits::template U<1> hit;
};

/// The slabs test. On an axis that the ray is parallel to, the planes must lie on both sides of the origin, or in it.
template <class Bits>
constexpr RayInterval<Bits> ray_interval(const std::array<PlaneDistances, 3>& planes, const std::array<RayAxis, 3>& ray,
                                         Float32 t_min, Float32 t_max) {
  RayInterval<Bits> interval{lift<Bits>(t_min), lift<Bits>(t_max), {}};
  auto outside = constant<Bits, 1>(0);
  const auto zero = typename Bits::template S<32>();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto parallel = lift<Bits>(ray[axis].parallel);
    const auto near = lift<Bits>(planes[axis].near);
    const auto far = lift<Bits>(planes[axis].far);
    interval.entry = select(parallel, interval.entry, larger_float<Bits>(interval.entry, near));
    interval.exit = select(parallel, interval.exit, smaller_float<Bits>(interval.exit, far));
    const auto beside = less(zero, order_key<Bits>(near)) | less(order_key<Bits>(far), zero);
    outside = outside | Bits::corner(Corner::ray_beside_box, parallel & beside);
  }
  interval.hit = ~less(order_key<Bits>(interval.exit), order_key<Bits>(interval.entry)) & ~outside;
  return interval;
}

/// A ray that has been set up against the root's own box, which no pair holds.
template <class Bits>
struct RootTest {
  RayInterval<Bits> interval;
  typename Bits::template U<3> status;  ///< of the setup, or not_finite for an end of the ray that is a NaN
};
template <class Bits>
constexpr RootTest<Bits> root_interval(const RaySetupResult& setup, Float32 t_min, Float32 t_max) {
  [[maybe_unused]] const typename Bits::Scope scope(Datapath::intersect_pair);
  const auto nan = is_nan<Bits>(lift<Bits>(t_min)) | is_nan<Bits>(lift<Bits>(t_max));
  const auto not_finite = constant<Bits, 3>(static_cast<std::uint64_t>(Status::not_finite));
  return {ray_interval<Bits>(setup.planes, setup.ray, t_min, t_max), select(nan, not_finite, lift<Bits>(setup.status))};
}

/// What no ray setup gives: an inverse that is negative or not finite, a NaN, an interval without an end on its side.
template <class Bits, int N>
constexpr auto refused_ray(const PairTestJob<N>& job) {
  const auto upwards = [](auto x) { return is_special<Bits>(x) & ~bits<31, 31>(x); };
  auto refused = is_nan<Bits>(lift<Bits>(job.t_min)) | is_nan<Bits>(lift<Bits>(job.t_max));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto inverse = lift<Bits>(job.ray[axis].inverse);
    const auto near = lift<Bits>(job.node.planes[axis].near);
    const auto far = lift<Bits>(job.node.planes[axis].far);
    refused = refused | bits<31, 31>(inverse) | is_special<Bits>(inverse) | is_nan<Bits>(near) | is_nan<Bits>(far) |
              upwards(near) | upwards(negate_float<Bits>(far));
  }
  return Bits::corner(Corner::ray_not_finite, refused);
}

/// Both children of a pair against a ray that reached their parent: figure 4's decoding, equation 5's distances and the
/// slabs test. One refused axis refuses the pair.
template <class Bits, int N>
constexpr PairTestResult<N> intersect_pair(const PairTestJob<N>& job) {
  [[maybe_unused]] const typename Bits::Scope scope(Datapath::intersect_pair);
  const auto not_finite = constant<Bits, 3>(static_cast<std::uint64_t>(Status::not_finite));
  auto status = select(refused_ray<Bits, N>(job), not_finite, constant<Bits, 3>(0));
  std::array<std::array<ChildAxis<Bits, N>, 3>, 2> children;
  for (std::size_t c = 0; c < 2; ++c) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const NodeCodes<N>& codes = job.pair.child[c];
      children[c][axis] = child_axis<Bits, N>(lift<Bits>(codes.lo[axis]), lift<Bits>(codes.hi[axis]),
                                              job.node.grid[axis], job.registers);
      status = first_reason<Bits>(status, children[c][axis].status);
    }
  }
  const auto refused = any(status);
  const auto gate = [&](auto wire) { return lower(select(refused, decltype(wire)(), wire)); };
  const auto gate_float = [&](Float32 x) { return lower_float(select(refused, constant<Bits, 32>(0), lift<Bits>(x))); };
  PairTestResult<N> result;
  std::array<RayInterval<Bits>, 2> intervals;
  for (std::size_t c = 0; c < 2; ++c) {
    TestedChild<N>& tested = result.child[c];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const ChildAxis<Bits, N>& child = children[c][axis];
      tested.node.planes[axis] =
          child_planes<Bits, N>(child, job.node.grid[axis], job.node.planes[axis], job.ray[axis]);
      tested.node.grid[axis] = {gate(child.scale), gate(child.lower), gate(child.cells)};
    }
    intervals[c] = ray_interval<Bits>(tested.node.planes, job.ray, job.t_min, job.t_max);
    tested.hit = gate(intervals[c].hit);
    tested.entry = gate_float(lower_float(intervals[c].entry));
    tested.exit = gate_float(lower_float(intervals[c].exit));
    for (PlaneDistances& planes : tested.node.planes) planes = {gate_float(planes.near), gate_float(planes.far)};
    tested.leaf = gate(lift<Bits>(job.pair.child[c].leaf));
    tested.pointer = gate(lift<Bits>(job.pair.child[c].pointer));
  }
  const auto both = intervals[0].hit & intervals[1].hit;
  const auto later = less(order_key<Bits>(intervals[1].entry), order_key<Bits>(intervals[0].entry));
  result.second_first = gate(Bits::corner(Corner::ray_second_first, both & later));
  result.status = lower(status);
  return result;
}

}  // namespace cbvh::rtl
