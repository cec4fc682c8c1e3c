// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "rtl_model/traverse/pair_intersector.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "rtl_model/traverse/ray_setter.h"
#include "tests/support/ray_walk.h"
#include "tests/support/unit_run.h"
#include "vectors/faces/directed_float.h"
#include "vectors/generate/floats.h"
#include "vectors/generate/pair_tests.h"
#include "vectors/ray_convert.h"

namespace cbvh::rtl {
namespace {

using testing::Disturbance;
using vectors::Random;

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kLargest = std::numeric_limits<float>::max();

float any_float(Random& random) {
  const std::uint64_t kind = random.below(4);
  if (kind == 0) return vectors::any_tiny_float(random);
  if (kind == 1) return vectors::any_huge_float(random);
  if (kind == 2) return std::ldexp(vectors::float_within(1, random), random.between(-30, 30));
  return vectors::any_finite_float(random);
}

template <int W>
float advanced(float x, int cells, float inverse, int scale) {
  const auto fields = break_float<MachineBits>(UInt<32>::of_raw(Float32::of(inverse).bits));
  return lower_float(advance_down<MachineBits>(UInt<32>::of_raw(Float32::of(x).bits),
                                               UInt<W>(static_cast<std::uint64_t>(cells)), fields, Scale(scale)))
      .value();
}

/// The product with its sign changed, within some last places: sums that cancel.
float cancelling(const vectors::Exact& product, Random& random) {
  float x = -vectors::largest_not_above(product);
  const float towards = random.flip() ? kInfinity : -kInfinity;
  for (int steps = random.between(0, 3); steps > 0; --steps) x = std::nextafter(x, towards);
  return std::isfinite(x) ? x : -kLargest;
}

TEST(PairIntersector, a_distance_advanced_by_cells_is_the_largest_float_not_above_the_exact_sum) {
  Random random(1);
  std::size_t checks = 0;
  std::size_t cancelled = 0;
  for (int i = 0; i < 300'000; ++i) {
    const float inverse = std::fabs(any_float(random));
    const int cells = random.between(0, 256);
    const int scale = random.flip() ? random.between(-256, 255) : random.between(-40, 10);
    const auto product = vectors::exact_product(cells, inverse, scale);
    const float x = random.flip() ? cancelling(product, random) : any_float(random);
    const auto exact = vectors::exact(x) + product;
    const float want = vectors::largest_not_above(exact);
    ASSERT_EQ(Float32::of(advanced<9>(x, cells, inverse, scale)).bits, Float32::of(want).bits)
        << x << " + " << cells << " * " << inverse << " * 2^" << scale;
    cancelled += x < 0 && std::fabs(want) < std::fabs(x) / 0x1p20F;
    ++checks;
  }
  EXPECT_EQ(checks, 300'000U);
  EXPECT_GT(cancelled, 50'000U);
  EXPECT_EQ(advanced<9>(-kInfinity, 256, kLargest, 255), -kInfinity);
  EXPECT_EQ(advanced<9>(kLargest, 256, kLargest, 255), kLargest);
  EXPECT_EQ(advanced<9>(-1, 1, 0x1p-149F, -256), -1) << "what lies far below the last place leads down, never up";
  EXPECT_EQ(advanced<9>(1, 1, 0x1p-149F, -256), 1);
}

/// A ray straight through a parent of 8 x 8 x 8 cells of size 1 at the origin, with one child of [2, 5) on each axis.
struct Scene {
  RaySetupJob ray;
  PairTestJob<6> job;

  Scene(std::array<float, 3> origin, std::array<float, 3> direction) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      ray.origin[axis] = Float32::of(origin[axis]);
      ray.direction[axis] = Float32::of(direction[axis]);
      ray.root.upper[axis] = Float32::of(8);
      job.node.grid[axis] = {Scale(0), UInt<6>(0), UInt<7>(8)};
      for (auto& child : job.pair.child) {
        child.lo[axis] = UInt<6>(2);
        child.hi[axis] = UInt<6>(5);
      }
    }
    job.registers = {Scale(-20), UInt<1>(0), UInt<1>(0)};
    job.t_max = Float32::of(kInfinity);
  }
  PairTestResult<6> run() {
    const RaySetupResult setup = ray_setup<MachineBits>(ray);
    EXPECT_EQ(setup.status.value(), 0U);
    job.ray = setup.ray;
    job.node.planes = setup.planes;
    const auto result = intersect_pair<MachineBits, 6>(job);
    EXPECT_EQ(result.status.value(), 0U);
    return result;
  }
};

TEST(PairIntersector, rays_parallel_to_an_axis_hit_exactly_when_they_lie_between_or_in_the_planes) {
  for (const float zero : {0.0F, -0.0F}) {
    for (const float at : {1.0F, 2.0F, 3.5F, 5.0F, std::nextafter(2.0F, 0.0F), std::nextafter(5.0F, 9.0F)}) {
      const auto result = Scene({at, 3, -1}, {zero, zero, 1}).run();
      EXPECT_EQ(result.child[0].hit.value(), at >= 2 && at <= 5 ? 1U : 0U) << at;
      EXPECT_EQ(result.child[0].entry.value(), 3.0F);
      EXPECT_EQ(result.child[0].exit.value(), 6.0F);
    }
  }
  EXPECT_EQ(Scene({3, 3, 3}, {0, 0, 0}).run().child[0].hit.value(), 1U) << "a point within";
  EXPECT_EQ(Scene({3, 3, 6}, {0, 0, 0}).run().child[0].hit.value(), 0U) << "a point beside";
}

TEST(PairIntersector, a_ray_in_a_face_along_an_edge_through_a_corner_or_from_inside_hits_forwards_and_backwards) {
  EXPECT_EQ(Scene({2, 3, 9}, {0, 0, -1}).run().child[0].hit.value(), 1U) << "in a face";
  EXPECT_EQ(Scene({2, 5, -1}, {-0.0F, 0, 1}).run().child[0].hit.value(), 1U) << "along an edge";
  EXPECT_EQ(Scene({0, 4, 2}, {1, -1, 0}).run().child[0].hit.value(), 1U)
      << "through an edge: it enters where it leaves";
  const auto corner = Scene({1, 6, 6}, {1, -1, -1}).run().child[0];
  EXPECT_EQ(corner.entry.value(), 1.0F);
  EXPECT_EQ(corner.exit.value(), 4.0F);
  const auto inside = Scene({3, 4, 4}, {-2, 0.5F, 0}).run().child[0];
  EXPECT_EQ(inside.hit.value(), 1U);
  EXPECT_EQ(inside.entry.value(), 0.0F) << "t_min";
  EXPECT_EQ(inside.exit.value(), 0.5F);
  EXPECT_EQ(Scene({9, 3, 3}, {1, 0, 0}).run().child[0].hit.value(), 0U) << "behind the ray";
}

TEST(PairIntersector, the_child_that_is_entered_first_goes_first_and_equal_ones_stay_in_order) {
  Scene scene({-1, 3, 3}, {1, 0, 0});
  scene.job.pair.child[1].lo[0] = UInt<6>(1);
  EXPECT_EQ(scene.run().second_first.value(), 1U);
  scene.job.pair.child[1].lo[0] = UInt<6>(2);
  EXPECT_EQ(scene.run().second_first.value(), 0U);
  scene.job.pair.child[1].lo[0] = UInt<6>(1);
  scene.job.pair.child[1].lo[1] = UInt<6>(4);  // missed
  EXPECT_EQ(scene.run().second_first.value(), 0U);
}

TEST(PairIntersector, the_upper_planes_distance_comes_from_the_parents_upper_plane) {
  // 1/3 rounded down: from the lower plane 5/3 would be 5 times it, from the upper one it is 8/3 less 3 times it.
  const auto child = Scene({0, 3, 3}, {3, 0, 0}).run().child[0];
  const float third = std::nextafter(1.0F / 3, 0.0F);
  EXPECT_LE(static_cast<double>(child.node.planes[0].near.value()) * 3, 2.0);
  EXPECT_GE(static_cast<double>(child.node.planes[0].far.value()) * 3, 5.0);
  EXPECT_LT(static_cast<double>(third) * 5 * 3, 5.0) << "a product with the same reciprocal alone does not enclose";
}

TEST(PairIntersector, no_interval_down_random_nested_boxes_fails_to_enclose_the_exact_one) {
  for (const testing::WalkedBoxes& walked :
       {testing::walk_rays<2>(200'000, 1), testing::walk_rays<6>(200'000, 2), testing::walk_rays<8>(200'000, 3)}) {
    EXPECT_GE(walked.tests, 200'000U);
    EXPECT_EQ(walked.violations, 0U);
    EXPECT_EQ(walked.refused, 0U);
    EXPECT_GT(walked.hits, walked.tests / 20);
    EXPECT_LT(walked.hits, walked.tests * 19 / 20);
  }
}

TEST(PairIntersector, refuses_a_child_that_leaves_its_parent_and_rays_that_no_setup_gives) {
  const auto status_of = [](auto&& spoil) {
    Scene scene({0, 3, 3}, {3, 0, 0});
    scene.run();
    spoil(scene.job);
    const auto result = intersect_pair<MachineBits, 6>(scene.job);
    PairTestResult<6> zeros;
    zeros.status = result.status;
    EXPECT_EQ(result, zeros);
    return static_cast<Status>(result.status.value());
  };
  using Job = PairTestJob<6>;
  EXPECT_EQ(status_of([](Job& job) { job.pair.child[1].hi[2] = UInt<6>(9); }), Status::too_wide);
  EXPECT_EQ(status_of([](Job& job) { job.pair.child[0].hi[0] = UInt<6>(2); }), Status::inverted);
  EXPECT_EQ(status_of([](Job& job) { job.node.grid[0].scale = Scale(-21); }), Status::scale_below_minimum);
  EXPECT_EQ(status_of([](Job& job) { job.t_max = Float32::of(NAN); }), Status::not_finite);
  EXPECT_EQ(status_of([](Job& job) { job.ray[1].inverse = Float32::of(kInfinity); }), Status::not_finite);
  EXPECT_EQ(status_of([](Job& job) { job.node.planes[1].near = Float32::of(kInfinity); }), Status::not_finite);
}

TEST(PairIntersector, has_latency_8_and_a_result_every_cycle_and_stalls_change_nothing) {
  Random random(4);
  std::vector<PairTestJob<6>> stimuli;
  for (std::size_t i = 0; i < 2400; ++i) {
    stimuli.push_back(vectors::to_wires<6>(vectors::make_pair_test(i % vectors::kPairTestClasses.size(), random, 6)));
  }
  const auto run = [&](const Disturbance& disturbance) {
    return testing::run_unit<PairTestJob<6>, PairTestResult<6>>(stimuli, disturbance, [](auto& in, auto& out) {
      return std::make_unique<PairIntersector<MachineBits, 6>>(in, out);
    });
  };
  const auto quiet = run({});
  ASSERT_EQ(quiet.responses.size(), stimuli.size());
  for (std::size_t i = 0; i < stimuli.size(); ++i) {
    ASSERT_EQ(quiet.latencies()[i], 8U);
    ASSERT_EQ(quiet.given[i], quiet.given[0] + i);
    ASSERT_EQ(quiet.responses[i], (intersect_pair<MachineBits, 6>(stimuli[i])));
  }
  for (const auto& disturbance : testing::stall_matrix()) EXPECT_EQ(run(disturbance).responses, quiet.responses);
}

}  // namespace
}  // namespace cbvh::rtl
