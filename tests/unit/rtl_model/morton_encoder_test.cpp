// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "rtl_model/lbvh/morton_encoder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <vector>

#include "golden/build/morton.h"
#include "tests/support/unit_run.h"

namespace cbvh::rtl {
namespace {

std::uint64_t coordinate(float lower, float upper, float scene_lower, float scene_upper) {
  const auto f = [](float x) { return lift<MachineBits>(Float32::of(x)); };
  return morton_coordinate<MachineBits>(f(lower), f(upper), morton_axis<MachineBits>(f(scene_lower), f(scene_upper)))
      .raw();
}

/// Counts what was met, so that a test cannot pass for want of cases.
struct Met {
  std::size_t flat = 0;
  std::size_t overflow = 0;
  std::size_t inside = 0;
};

void expect_golden(float lower, float upper, float scene_lower, float scene_upper, Met& met) {
  const std::uint32_t want = golden::morton_axis(lower, upper, scene_lower, scene_upper);
  ASSERT_EQ(coordinate(lower, upper, scene_lower, scene_upper), want)
      << std::hexfloat << lower << ' ' << upper << " in " << scene_lower << ' ' << scene_upper;
  met.flat += !(scene_upper > scene_lower);
  met.overflow += scene_upper - scene_lower == std::numeric_limits<float>::infinity();
  met.inside += want > 0 && want < 1023;
}

std::vector<float> boundary_floats() {
  std::vector<float> values;
  for (const float magnitude : {0.0F,           0x1p-149F,
                                0x3p-149F,      0x1.fffffcp-127F,
                                0x1p-126F,      0x1.8p-126F,
                                0x1p-125F,      0x1p-24F,
                                0x1.fffffep-2F, 0.5F,
                                1.0F,           0x1.000002p0F,
                                3.0F,           1023.0F,
                                1024.0F,        0x1.fffffep125F,
                                0x1p126F,       0x1.fffffep126F,
                                0x1p127F,       std::numeric_limits<float>::max()}) {
    values.push_back(magnitude);
    values.push_back(-magnitude);
  }
  return values;
}

TEST(MortonEncoder, equals_the_golden_on_every_four_boundaries) {
  Met met;
  const auto values = boundary_floats();
  for (const float scene_lower : values) {
    for (const float scene_upper : values) {
      for (const float lower : values) {
        for (const float upper : values) {
          expect_golden(lower, upper, scene_lower, scene_upper, met);
          if (HasFatalFailure()) return;
        }
      }
    }
  }
  EXPECT_GT(met.flat, 1'000'000U);
  EXPECT_GT(met.overflow, 15'000U);
  EXPECT_GT(met.inside, 10'000U);
}

/// Any finite float.
float any_float(SplitMix64& random) {
  std::uint32_t bits = 0;
  do {
    bits = static_cast<std::uint32_t>(random.next());
  } while ((bits & 0x7F800000U) == 0x7F800000U);
  return std::bit_cast<float>(bits);
}
float unit(SplitMix64& random) { return static_cast<float>(random.next() >> 40) * 0x1p-24F; }

TEST(MortonEncoder, equals_the_golden_on_random_boxes_of_every_magnitude_and_on_cell_borders) {
  SplitMix64 random(5);
  Met met;
  for (int i = 0; i < 1'500'000; ++i) {
    float scene_lower = any_float(random);
    float scene_upper = any_float(random);
    float lower = any_float(random);
    float upper = any_float(random);
    if (i % 3 != 0) {  // inside, sizes as in scenes, now and then at the ends of the format
      const std::uint64_t smallest = i % 10 == 1 ? 0x7E800000U : 0;
      const float size =
          std::bit_cast<float>(static_cast<std::uint32_t>(smallest + random.below(0x7F800000U - smallest)));
      scene_lower = i % 3 == 1 ? -size : size * unit(random);
      scene_upper = i % 3 == 1 ? size : std::min(size + scene_lower, std::numeric_limits<float>::max());
      const float extent = scene_upper * 0.5F - scene_lower * 0.5F;
      const float place = i % 2 == 0 ? unit(random) : static_cast<float>(random.below(1025)) / 1024.0F;
      lower = scene_lower + extent * place + extent * place;
      upper = i % 5 == 0 ? lower : std::nextafter(lower, scene_upper);
      if (!std::isfinite(lower) || !std::isfinite(upper)) continue;
    }
    expect_golden(lower, upper, scene_lower, scene_upper, met);
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(met.flat, 100'000U);
  EXPECT_GT(met.overflow, 25'000U);
  EXPECT_GT(met.inside, 500'000U);
}

std::vector<PrimitiveBox> random_boxes(std::size_t count) {
  SplitMix64 random(23);
  std::vector<PrimitiveBox> boxes;
  for (std::size_t i = 0; i < count; ++i) {
    PrimitiveBox box;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const float lower = unit(random) * 8 - 4;
      box.box.lower[axis] = Float32::of(lower);
      box.box.upper[axis] = Float32::of(lower + unit(random));
    }
    box.id = Pointer(i);
    box.last = UInt<1>(i + 1 == count);
    boxes.push_back(box);
  }
  return boxes;
}

constexpr float kSceneLower[] = {-4, -5, -3};
constexpr float kSceneUpper[] = {5, 4.5F, 6};
SceneBox scene_box() {
  SceneBox registers;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    registers.scene.lower[axis] = Float32::of(kSceneLower[axis]);
    registers.scene.upper[axis] = Float32::of(kSceneUpper[axis]);
  }
  return registers;
}

std::vector<SortItem> expected_items(const std::vector<PrimitiveBox>& boxes) {
  std::vector<SortItem> items;
  for (const PrimitiveBox& box : boxes) {
    golden::Box plain{};
    golden::Box scene{};
    for (int axis = 0; axis < 3; ++axis) {
      const auto a = static_cast<std::size_t>(axis);
      plain.lower[axis] = box.box.lower[a].value();
      plain.upper[axis] = box.box.upper[a].value();
      scene.lower[axis] = kSceneLower[axis];
      scene.upper[axis] = kSceneUpper[axis];
    }
    items.push_back({{box.box, UInt<kMortonBits>(golden::morton_code(plain, scene)), box.id}, UInt<1>(0), box.last});
  }
  return items;
}

TEST(MortonEncoder, has_latency_36_and_a_result_every_cycle_and_stalls_change_nothing) {
  const auto boxes = random_boxes(3000);
  const auto want = expected_items(boxes);
  for (const auto& disturbance : testing::stall_matrix()) {
    const auto observed = testing::run_unit<PrimitiveBox, SortItem>(boxes, disturbance, [](auto& in, auto& out) {
      return std::make_unique<MortonEncoder<MachineBits>>(in, out, scene_box());
    });
    ASSERT_EQ(observed.responses, want);
    if (disturbance.source_stalls || disturbance.sink_stalls) continue;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      ASSERT_EQ(observed.latencies()[i], 36U);
      ASSERT_EQ(observed.accepted[i], observed.accepted[0] + i);
    }
  }
}

TEST(MortonEncoder, tells_the_first_primitive_that_was_refused) {
  auto boxes = random_boxes(50);
  for (const std::size_t i : {20U, 30U}) {
    boxes[i].box = {};
    boxes[i].status = StatusBits(static_cast<std::uint64_t>(Status::not_finite));
  }
  Channel<PrimitiveBox> in;
  Channel<SortItem> out;
  MortonEncoder<MachineBits> encoder(in, out, scene_box());
  Clock clock(in, encoder, out);
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    in.push(boxes[i]);
    if (out.can_pop()) out.pop();
    clock.step();
    EXPECT_EQ(encoder.first_refused().has_value(), i > 20) << i;
  }
  EXPECT_EQ(encoder.first_refused(), Pointer(20));
}

}  // namespace
}  // namespace cbvh::rtl
