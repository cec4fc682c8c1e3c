// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "rtl_model/lbvh/box_builder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "tests/support/unit_run.h"

namespace cbvh::rtl {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
const float kNan = std::numeric_limits<float>::quiet_NaN();

std::vector<float> boundary_floats() {
  std::vector<float> values = {kInfinity, -kInfinity, kNan, -kNan};
  for (const float magnitude :
       {0.0F, 0x1p-149F, 0x1.fffffcp-127F, 0x1p-126F, 0.5F, 1.0F, 0x1.000002p0F, std::numeric_limits<float>::max()}) {
    values.push_back(magnitude);
    values.push_back(-magnitude);
  }
  return values;
}

/// Every three boundaries on the first axis, what is next to them on the others; then random bits.
std::vector<Primitive> primitives() {
  std::vector<Primitive> result;
  const auto values = boundary_floats();
  const auto add = [&](auto&& coordinate) {
    Primitive primitive;
    for (std::size_t vertex = 0; vertex < 3; ++vertex) {
      for (std::size_t axis = 0; axis < 3; ++axis) primitive.vertex[vertex][axis] = coordinate(vertex, axis);
    }
    primitive.id = Pointer(result.size());
    primitive.last = UInt<1>(result.size() % 100 == 99);
    result.push_back(primitive);
  };
  for (std::size_t i = 0; i < values.size() * values.size() * values.size(); ++i) {
    add([&](std::size_t vertex, std::size_t axis) {
      if (axis == 1) return Float32::of(static_cast<float>((i + vertex) % 5));
      const std::size_t digit[] = {i % values.size(), i / values.size() % values.size(),
                                   i / values.size() / values.size()};
      return Float32::of(values[(digit[vertex] + (axis == 0 ? 0 : vertex)) % values.size()]);
    });
  }
  SplitMix64 random(31);
  for (int i = 0; i < 20000; ++i) {
    add([&](std::size_t, std::size_t) { return Float32::of_raw(random.next()); });
  }
  return result;
}

PrimitiveBox expected(const Primitive& primitive) {
  PrimitiveBox result;
  result.id = primitive.id;
  result.last = primitive.last;
  for (const auto& vertex : primitive.vertex) {
    for (const Float32 coordinate : vertex) {
      if (std::isfinite(coordinate.value())) continue;
      result.status = StatusBits(static_cast<std::uint64_t>(Status::not_finite));
      return result;
    }
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto [lower, upper] = std::minmax(
        {primitive.vertex[0][axis].value(), primitive.vertex[1][axis].value(), primitive.vertex[2][axis].value()});
    result.box.lower[axis] = Float32::of(lower == 0 ? 0.0F : lower);
    result.box.upper[axis] = Float32::of(upper == 0 ? 0.0F : upper);
  }
  return result;
}

TEST(BoxBuilder, gives_the_smallest_box_with_positive_zeros_two_cycles_later_and_stalls_change_nothing) {
  const auto stimuli = primitives();
  std::vector<PrimitiveBox> want;
  std::size_t refused = 0;
  for (const Primitive& primitive : stimuli) {
    want.push_back(expected(primitive));
    refused += want.back().status != StatusBits();
  }
  EXPECT_GT(refused, 3000U);
  EXPECT_GT(stimuli.size() - refused, 15000U);
  for (const auto& disturbance : testing::stall_matrix()) {
    const auto observed = testing::run_unit<Primitive, PrimitiveBox>(
        stimuli, disturbance, [](auto& in, auto& out) { return std::make_unique<BoxBuilder<MachineBits>>(in, out); });
    ASSERT_EQ(observed.responses, want);
    if (disturbance.source_stalls || disturbance.sink_stalls) continue;
    for (std::size_t i = 0; i < stimuli.size(); ++i) {
      ASSERT_EQ(observed.latencies()[i], 2U);
      ASSERT_EQ(observed.accepted[i], observed.accepted[0] + i);
    }
  }
}

}  // namespace
}  // namespace cbvh::rtl
