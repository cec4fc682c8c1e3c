// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "rtl_model/compress/axis_compressor.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "golden/quantize/quantize.h"
#include "rtl_model/compress/scale_estimator.h"
#include "tests/support/unit_run.h"

namespace cbvh::rtl {
namespace {

using testing::Disturbance;

/// Intervals that meet at boundaries: every pair of these, and random ones between.
std::vector<float> boundary_floats() {
  std::vector<float> values;
  for (const float magnitude :
       {0.0f, 1e-45f, 1.1754942e-38f, 1.17549435e-38f, 0.4f, 0.5f, 0.99999994f, 1.0f, 1.0000001f, 63.0f, 64.0f,
        64.00001f, 8388607.5f, 16777215.0f, 1.7014118e38f, std::numeric_limits<float>::max()}) {
    values.push_back(magnitude);
    values.push_back(-magnitude);
  }
  return values;
}

struct Interval {
  float lower;
  float upper;
};

std::vector<Interval> intervals() {
  std::vector<Interval> result;
  const auto values = boundary_floats();
  for (const float lower : values) {
    for (const float upper : values) {
      if (lower <= upper) result.push_back({lower, upper});
    }
  }
  SplitMix64 random(11);
  for (int i = 0; i < 20000; ++i) {
    const auto any_float = [&] {
      const auto bits = static_cast<std::uint32_t>(random.next());
      return std::bit_cast<float>((bits & 0x807FFFFFu) | static_cast<std::uint32_t>(100 + random.below(60)) << 23);
    };
    const float a = any_float();
    const float b = random.below(2) == 0 ? any_float() : a + std::ldexp(a, -static_cast<int>(random.below(24)));
    result.push_back({std::min(a, b), std::max(a, b)});
  }
  return result;
}

template <int N>
void expect_equals_golden(golden::ScaleRule rule) {
  std::size_t checks = 0;
  for (const auto& [lower, upper] : intervals()) {
    golden::GridRules rules{N, golden::exactness_limit(std::max(std::abs(lower), std::abs(upper))), rule};
    const int finest = golden::enclosing_scale(lower, upper, rules);
    const SceneRegisters registers{Scale(rules.min_scale), UInt<1>(rule == golden::ScaleRule::figure5), UInt<1>(0)};
    const auto estimate = estimate_scale<MachineBits, N>({Float32::of(lower), Float32::of(upper), registers});
    ASSERT_EQ(estimate.status.value(), 0u) << lower << ' ' << upper;
    ASSERT_EQ(estimate.scale.value(), finest) << lower << ' ' << upper;
    ASSERT_EQ(estimate.lower.value(), golden::floor_on_grid<std::int64_t>(lower, finest));
    for (const int coarser : {0, 1, 2, 5, 23, 24, 40}) {
      const int scale = std::min(finest + coarser, 128);
      const auto result =
          compress_axis<MachineBits, N>({Float32::of(lower), Float32::of(upper), Scale(scale), registers});
      const auto cells = golden::encode<std::int64_t>(lower, upper, scale);
      const auto own = golden::own_context(cells, scale, rules);
      ASSERT_EQ(result.status.value(), 0u) << lower << ' ' << upper << ' ' << scale;
      const auto mask = (std::int64_t{1} << N) - 1;
      ASSERT_EQ(static_cast<std::int64_t>(result.code_lo.value()), cells.lower & mask);
      ASSERT_EQ(static_cast<std::int64_t>(result.code_hi.value()), cells.upper & mask);
      ASSERT_EQ(result.own_scale.value(), own.scale) << lower << ' ' << upper << ' ' << scale;
      ASSERT_EQ(result.own_lower.value(), own.lower);
      ASSERT_EQ(result.edge_lo, Float32::of(golden::edge(cells.lower, scale) + 0.0f));
      ASSERT_EQ(result.edge_hi, Float32::of(golden::edge(cells.upper, scale) + 0.0f));
      checks += 7;
    }
  }
  EXPECT_GT(checks, 900000u);
}

TEST(AxisCompressor, equals_the_golden_on_boundaries_crossed_with_random_for_every_width) {
  for (const auto rule : {golden::ScaleRule::equation2, golden::ScaleRule::figure5}) {
    expect_equals_golden<2>(rule);
    expect_equals_golden<3>(rule);
    expect_equals_golden<5>(rule);
    expect_equals_golden<6>(rule);
    expect_equals_golden<8>(rule);
  }
}

AxisResult<6> compress(float lower, float upper, int scale, int min_scale) {
  return compress_axis<MachineBits, 6>(
      {Float32::of(lower), Float32::of(upper), Scale(scale), {Scale(min_scale), {}, {}}});
}

void expect_refused(const AxisResult<6>& result, Status status) {
  AxisResult<6> want;
  want.status = StatusBits(static_cast<std::uint64_t>(status));
  EXPECT_EQ(result, want);
}

TEST(AxisCompressor, refuses_what_it_cannot_encode_with_the_first_reason_and_zeros) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinity = std::numeric_limits<float>::infinity();
  expect_refused(compress(nan, 1, 0, -20), Status::not_finite);
  expect_refused(compress(0, infinity, 0, -20), Status::not_finite);
  expect_refused(compress(-infinity, 0, 0, -20), Status::not_finite);
  expect_refused(compress(2, 1, 0, -20), Status::inverted);
  expect_refused(compress(-1, -2, 0, -20), Status::inverted);
  expect_refused(compress(1, 1.5f, 0, -24), Status::beyond_exactness);
  expect_refused(compress(1, 1.5f, -21, -20), Status::scale_below_minimum);
  expect_refused(compress(0, 64, 0, -17), Status::too_wide);
  EXPECT_EQ(compress(0, 63.5f, 0, -17).status.value(), 0u);
}

TEST(AxisCompressor, zero_is_zero_whatever_its_sign) {
  EXPECT_EQ(compress(-0.0f, 0.0f, 0, -20), compress(0.0f, -0.0f, 0, -20));
  EXPECT_EQ(compress(-0.0f, 1.0f, 0, -20), compress(0.0f, 1.0f, 0, -20));
}

TEST(AxisCompressor, an_edge_of_two_to_the_128_is_infinite) {
  const float largest = std::numeric_limits<float>::max();
  const auto result = compress(-largest, largest, 123, 104);
  EXPECT_EQ(result.status.value(), 0u);
  EXPECT_EQ(result.edge_hi.value(), std::numeric_limits<float>::infinity());
  EXPECT_EQ(result.edge_lo.value(), -std::numeric_limits<float>::infinity());
}

std::vector<AxisJob> jobs() {
  std::vector<AxisJob> result;
  for (const auto& [lower, upper] : intervals()) {
    const golden::GridRules rules{6, golden::exactness_limit(std::max(std::abs(lower), std::abs(upper)))};
    result.push_back({Float32::of(lower),
                      Float32::of(upper),
                      Scale(golden::enclosing_scale(lower, upper, rules)),
                      {Scale(rules.min_scale), {}, {}}});
  }
  return result;
}

TEST(AxisCompressor, has_latency_3_and_a_result_every_cycle_and_stalls_change_nothing) {
  const auto stimuli = jobs();
  const auto run = [&](const Disturbance& disturbance) {
    return testing::run_unit<AxisJob, AxisResult<6>>(stimuli, disturbance, [](auto& in, auto& out) {
      return std::make_unique<AxisCompressor<MachineBits, 6>>(in, out);
    });
  };
  const auto quiet = run({});
  ASSERT_EQ(quiet.responses.size(), stimuli.size());
  for (std::size_t i = 0; i < stimuli.size(); ++i) {
    ASSERT_EQ(quiet.latencies()[i], 3u);
    ASSERT_EQ(quiet.responses[i], (compress_axis<MachineBits, 6>(stimuli[i])));
  }
  for (const auto& disturbance : testing::stall_matrix()) EXPECT_EQ(run(disturbance).responses, quiet.responses);
}

}  // namespace
}  // namespace cbvh::rtl
