// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "vectors/faces/ray.h"

#include <bit>
#include <cmath>
#include <cstdint>

#include "golden/quantize/quantize.h"
#include "vectors/faces/axis.h"
#include "vectors/faces/directed_float.h"

namespace cbvh::vectors {

using rtl::Status;

namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// The largest finite float whose product with d, which is above 0, is not above 1.
float reciprocal_down(float d) {
  std::uint32_t low = 0;  // bits of positive floats order like they do
  std::uint32_t high = std::bit_cast<std::uint32_t>(kInfinity);
  while (high - low > 1) {
    const std::uint32_t middle = low + (high - low) / 2;
    const bool fits = static_cast<double>(std::bit_cast<float>(middle)) * static_cast<double>(d) <= 1;  // exact
    (fits ? low : high) = middle;
  }
  return std::bit_cast<float>(low);
}

/// The smallest float whose product with d is not below 1.
float reciprocal_up(float d) {
  const float down = reciprocal_down(d);
  return static_cast<double>(down) * static_cast<double>(d) == 1 ? down : std::nextafter(down, kInfinity);
}

/// to - from, rounded down; an infinite `to` stays.
float offset_down(float to, float from) { return std::isinf(to) ? to : largest_not_above(exact(to) - exact(from)); }

/// offset / d rounded down, d > 0: see set_up_axis.
float distance_down(float offset, float d) {
  if (offset == 0 || std::isinf(offset)) return offset;
  const float inverse = offset > 0 ? reciprocal_down(d) : reciprocal_up(d);
  if (std::isinf(inverse)) return -kInfinity;
  return golden::round_down(static_cast<double>(offset) * static_cast<double>(inverse)) + 0.0F;  // the product is exact
}

/// `from` and `cells` more of them.
float advance_down(float from, int cells, float inverse, int scale) {
  return std::isinf(from) ? from : largest_not_above(exact(from) + exact_product(cells, inverse, scale));
}

struct ChildAxis {
  Status status = Status::ok;
  int from_lower = 0;
  int from_upper = 0;
  PlainGridAxis own{};
};

ChildAxis child_axis(golden::AxisCodes codes, const PlainGridAxis& parent, const rtl::SceneRegisters& registers,
                     int bits) {
  const golden::GridRules rules = rules_of(registers, bits);
  const auto cells = golden::decode_codes<Index>(codes, parent.lower, code_of(registers), bits);
  const Index span = cells.upper - cells.lower;
  if (span <= 0) return {Status::inverted};
  if (parent.scale < rules.min_scale) return {Status::scale_below_minimum};
  if (span > rules.max_cells() || cells.upper > parent.lower + parent.cells) return {Status::too_wide};
  const auto own = golden::own_context(cells, parent.scale, rules);
  return {Status::ok,
          static_cast<int>(cells.lower - parent.lower),
          static_cast<int>(parent.lower + parent.cells - cells.upper),
          {own.scale, static_cast<int>(golden::modulo(own.lower, bits)),
           static_cast<int>(golden::times_power_of_two(span, parent.scale - own.scale))}};
}

PlainDistances child_planes(const ChildAxis& child, const PlainGridAxis& parent, const PlainDistances& planes,
                            const PlainRayAxis& ray) {
  const int to_near = ray.backwards ? child.from_upper : child.from_lower;
  const int to_far = ray.backwards ? child.from_lower : child.from_upper;
  return {advance_down(planes.near, to_near, ray.inverse, parent.scale) + 0.0F,
          0.0F - advance_down(-planes.far, to_far, ray.inverse, parent.scale)};
}

bool refuses_ray(const PlainPairTest& test) {
  bool refused = std::isnan(test.t_min) || std::isnan(test.t_max);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const float inverse = test.ray[axis].inverse;
    const auto [near, far] = test.node.planes[axis];
    refused = refused || !std::isfinite(inverse) || std::signbit(inverse) || std::isnan(near) || near == kInfinity ||
              std::isnan(far) || far == -kInfinity;
  }
  return refused;
}

}  // namespace

AxisSetup set_up_axis(float origin, float direction, float lower, float upper) {
  const bool backwards = direction < 0;
  const float from = backwards ? -origin : origin;
  const float near_plane = backwards ? -upper : lower;
  const float far_plane = backwards ? -lower : upper;
  const float to_near = offset_down(near_plane, from);
  const float to_far_negated = offset_down(-far_plane, -from);
  if (direction == 0) return {{1, false, true}, {to_near, 0.0F - to_far_negated}};
  const float d = std::fabs(direction);
  return {{reciprocal_down(d), backwards, false}, {distance_down(to_near, d), 0.0F - distance_down(to_far_negated, d)}};
}

Status setup_status(float origin, float direction, float lower, float upper) {
  const bool bounds = lower < kInfinity && upper > -kInfinity;  // false of a NaN
  if (!std::isfinite(origin) || !std::isfinite(direction) || !bounds) return Status::not_finite;
  return lower > upper ? Status::inverted : Status::ok;
}

BoxInterval box_interval(const std::array<PlainDistances, 3>& planes, const std::array<PlainRayAxis, 3>& ray,
                         float t_min, float t_max) {
  BoxInterval inside{true, t_min, t_max};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto [near, far] = planes[axis];
    if (ray[axis].parallel) {
      if (near > 0 || far < 0) inside.hit = false;
    } else {
      if (near > inside.entry) inside.entry = near;
      if (far < inside.exit) inside.exit = far;
    }
  }
  inside.hit = inside.hit && inside.entry <= inside.exit;
  return inside;
}

PairTestAnswer test_pair(const PlainPairTest& test, int bits) {
  PairTestAnswer answer;
  std::array<std::array<ChildAxis, 3>, 2> children;
  if (refuses_ray(test)) answer.status = Status::not_finite;
  for (std::size_t c = 0; c < 2; ++c) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      children[c][axis] = child_axis(test.pair.child[c].codes[axis], test.node.grid[axis], test.registers, bits);
      const Status found = children[c][axis].status;
      if (found != Status::ok && (answer.status == Status::ok || found < answer.status)) answer.status = found;
    }
  }
  if (answer.status != Status::ok) return answer;
  for (std::size_t c = 0; c < 2; ++c) {
    TestedBox& box = answer.child[c];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const ChildAxis& child = children[c][axis];
      box.node.grid[axis] = child.own;
      box.node.planes[axis] = child_planes(child, test.node.grid[axis], test.node.planes[axis], test.ray[axis]);
    }
    box.inside = box_interval(box.node.planes, test.ray, test.t_min, test.t_max);
  }
  const BoxInterval& first = answer.child[0].inside;
  const BoxInterval& second = answer.child[1].inside;
  answer.second_first = first.hit && second.hit && second.entry < first.entry;
  return answer;
}

}  // namespace cbvh::vectors
