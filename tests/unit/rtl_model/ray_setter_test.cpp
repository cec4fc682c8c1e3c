// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "rtl_model/traverse/ray_setter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "tests/support/unit_run.h"
#include "vectors/generate/floats.h"
#include "vectors/generate/ray_setup_jobs.h"

namespace cbvh::rtl {
namespace {

using testing::Disturbance;
using vectors::Random;

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kLargest = std::numeric_limits<float>::max();

TEST(RaySetter, a_reciprocal_lies_between_its_two_roundings_for_every_kind_of_float) {
  Random random(1);
  std::size_t exact = 0;
  for (int i = 0; i < 300'000; ++i) {
    const bool tiny = random.one_in(3);
    const float d = i < 277 ? std::ldexp(1.0F, i - 149)
                    : tiny  ? vectors::any_tiny_float(random)
                            : vectors::any_finite_float(random);
    if (d == 0) continue;
    const auto both = reciprocal<MachineBits>(UInt<32>::of_raw(Float32::of(d).bits));
    const float down = lower_float(both.down).value();
    const float up = lower_float(both.up).value();
    const double magnitude = std::fabs(static_cast<double>(d));  // products of two floats are exact
    ASSERT_LE(static_cast<double>(down) * magnitude, 1.0) << d;
    ASSERT_GE(static_cast<double>(up) * magnitude, 1.0) << d;
    ASSERT_TRUE(down == up || up == std::nextafter(down, kInfinity)) << d;
    exact += down == up;
  }
  EXPECT_GE(exact, 253U) << "powers of two";
}

RaySetupResult set_up(float origin, float direction, float lower, float upper) {
  RaySetupJob job;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    job.origin[axis] = Float32::of(origin);
    job.direction[axis] = Float32::of(direction);
    job.root.lower[axis] = Float32::of(lower);
    job.root.upper[axis] = Float32::of(upper);
  }
  return ray_setup<MachineBits>(job);
}

TEST(RaySetter, distances_run_along_the_ray_and_a_direction_of_either_zero_is_parallel) {
  const auto forwards = set_up(1, 2, 3, 5);
  EXPECT_EQ(forwards.planes[0], (PlaneDistances{Float32::of(1), Float32::of(2)}));
  const auto backwards = set_up(1, -2, 3, 5);
  EXPECT_EQ(backwards.planes[0], (PlaneDistances{Float32::of(-2), Float32::of(-1)}));
  EXPECT_EQ(backwards.ray[0], (RayAxis{Float32::of(0.5F), UInt<1>(1), UInt<1>(0)}));
  for (const float zero : {0.0F, -0.0F}) {
    const auto parallel = set_up(1, zero, 3, 5);
    EXPECT_EQ(parallel.planes[0], (PlaneDistances{Float32::of(2), Float32::of(4)}));
    EXPECT_EQ(parallel.ray[0], (RayAxis{Float32::of(1), UInt<1>(0), UInt<1>(1)}));
  }
  EXPECT_EQ(set_up(3, -1, 3, 3).planes[0], (PlaneDistances{})) << "zeros are +0";
}

TEST(RaySetter, what_no_float_holds_becomes_the_largest_float_or_an_infinity_away_from_the_box) {
  const auto steep = set_up(0, 0x1p-149F, 1, 2);
  EXPECT_EQ(steep.ray[0].inverse.value(), kLargest);
  EXPECT_EQ(steep.planes[0].near.value(), kLargest) << "not infinite: the exact one is finite";
  EXPECT_EQ(steep.planes[0].far.value(), kInfinity);
  const auto behind = set_up(0, 0x1p-149F, -2, -1);
  EXPECT_EQ(behind.planes[0].near.value(), -kInfinity);
  EXPECT_EQ(behind.planes[0].far.value(), -kLargest);
  const auto edges = set_up(0, -1, -kInfinity, kInfinity);
  EXPECT_EQ(edges.planes[0], (PlaneDistances{Float32::of(-kInfinity), Float32::of(kInfinity)}));
}

TEST(RaySetter, refuses_what_is_not_finite_before_what_is_inverted) {
  const auto status_of = [](const RaySetupResult& result) { return static_cast<Status>(result.status.value()); };
  EXPECT_EQ(status_of(set_up(NAN, 1, 2, 1)), Status::not_finite);
  EXPECT_EQ(status_of(set_up(0, kInfinity, 0, 1)), Status::not_finite);
  EXPECT_EQ(status_of(set_up(0, 1, kInfinity, kInfinity)), Status::not_finite);
  EXPECT_EQ(status_of(set_up(0, 1, 2, 1)), Status::inverted);
  EXPECT_EQ(status_of(set_up(0, 1, -0.0F, 0.0F)), Status::ok);
  EXPECT_EQ(status_of(set_up(0, 1, 0.0F, -0.0F)), Status::ok);
}

TEST(RaySetter, has_latency_32_and_a_result_every_cycle_and_stalls_change_nothing) {
  Random random(4);
  std::vector<RaySetupJob> stimuli;
  for (std::size_t i = 0; i < 2000; ++i) {
    stimuli.push_back(vectors::make_ray_setup_job(i % vectors::kRaySetupClasses.size(), random));
  }
  const auto run = [&](const Disturbance& disturbance) {
    return testing::run_unit<RaySetupJob, RaySetupResult>(
        stimuli, disturbance, [](auto& in, auto& out) { return std::make_unique<RaySetter<MachineBits>>(in, out); });
  };
  const auto quiet = run({});
  ASSERT_EQ(quiet.responses.size(), stimuli.size());
  for (std::size_t i = 0; i < stimuli.size(); ++i) {
    ASSERT_EQ(quiet.latencies()[i], 32U);
    ASSERT_EQ(quiet.given[i], quiet.given[0] + i);
    ASSERT_EQ(quiet.responses[i], ray_setup<MachineBits>(stimuli[i]));
  }
  for (const auto& disturbance : testing::stall_matrix()) EXPECT_EQ(run(disturbance).responses, quiet.responses);
}

}  // namespace
}  // namespace cbvh::rtl
