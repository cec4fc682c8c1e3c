// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <set>

#include "golden/quantize/quantize.h"
#include "vectors/faces/axis.h"
#include "vectors/faces/directed_float.h"
#include "vectors/faces/ray.h"
#include "vectors/generate/floats.h"
#include "vectors/generate/ray_episodes.h"
#include "vectors/generate/ray_setup_jobs.h"
#include "vectors/ray_tree.h"

/// The golden faces of the units that send rays, against rationals of unlimited size.
namespace cbvh::vectors {
namespace {

using Rational = boost::multiprecision::cpp_rational;
constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kLargest = std::numeric_limits<float>::max();

float any_float(Random& random) {
  switch (random.below(3)) {
    case 0:
      return any_tiny_float(random);
    case 1:
      return any_huge_float(random);
    default:
      return any_finite_float(random);
  }
}

/// x is the largest float, infinities included, that is not above the value.
void expect_largest_not_above(float x, const Rational& value) {
  EXPECT_FALSE(x == 0 && std::signbit(x));
  if (std::isinf(x)) {
    EXPECT_LT(x, 0);
    EXPECT_LT(value, Rational(-kLargest));
    return;
  }
  EXPECT_LE(Rational(x), value);
  const float next = std::nextafter(x, kInfinity);
  if (std::isfinite(next)) {
    EXPECT_GT(Rational(next), value);
  }
}

TEST(RayFaces, directed_rounding_gives_the_float_next_to_the_exact_value) {
  Random random(1);
  std::size_t checks = 0;
  for (int i = 0; i < 20'000; ++i) {
    const float x = any_float(random);
    const float inverse = std::fabs(any_float(random));
    const int cells = random.between(0, 256);
    const int scale = random.one_in(2) ? random.between(-256, 255) : random.between(-30, 0);
    const Rational power = scale < 0 ? Rational(1) / (Rational(boost::multiprecision::cpp_int(1) << -scale))
                                     : Rational(boost::multiprecision::cpp_int(1) << scale);
    const Rational value = Rational(x) + cells * Rational(inverse) * power;
    expect_largest_not_above(largest_not_above(exact(x) + exact_product(cells, inverse, scale)), value);
    expect_largest_not_above(0.0F - smallest_not_below(-exact(x) - exact_product(cells, inverse, scale)), value);
    checks += 2;
    if (::testing::Test::HasFailure()) break;
  }
  EXPECT_EQ(checks, 40'000U);
  EXPECT_EQ(largest_not_above(exact(0.0F)), 0.0F);
}

/// Where the ray meets a plane on an axis: t, or its offset where the ray is parallel.
Rational exact_distance(double plane, float origin, float direction) {
  const Rational offset = Rational(plane) - Rational(origin);
  return direction == 0 ? offset : Rational(offset / Rational(direction));
}

TEST(RayFaces, a_ray_setup_encloses_the_exact_distances_and_its_reciprocal_is_the_largest_float_that_is_not_above) {
  Random random(2);
  std::size_t axes = 0;
  std::size_t tight = 0;
  for (int i = 0; i < 8'000; ++i) {
    const rtl::RaySetupJob job = make_ray_setup_job(static_cast<std::size_t>(i) % kValidRays, random);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const float origin = job.origin[axis].value();
      const float direction = job.direction[axis].value();
      const float lower = job.root.lower[axis].value();
      const float upper = job.root.upper[axis].value();
      ASSERT_EQ(setup_status(origin, direction, lower, upper), rtl::Status::ok);
      const AxisSetup setup = set_up_axis(origin, direction, lower, upper);
      ASSERT_EQ(setup.ray.parallel, direction == 0);
      ASSERT_EQ(setup.ray.backwards, direction < 0);
      if (direction == 0) {
        ASSERT_EQ(setup.ray.inverse, 1.0F);
      } else {
        expect_largest_not_above(setup.ray.inverse, 1 / abs(Rational(direction)));
      }
      const double near_plane = direction < 0 ? upper : lower;
      const double far_plane = direction < 0 ? lower : upper;
      if (std::isfinite(setup.planes.near)) {
        ASSERT_LE(Rational(setup.planes.near), exact_distance(near_plane, origin, direction)) << i;
        const float above = std::nextafter(std::nextafter(setup.planes.near, kInfinity), kInfinity);
        tight += std::isinf(above) || Rational(above) > exact_distance(near_plane, origin, direction);
      }
      if (std::isfinite(setup.planes.far)) {
        ASSERT_GE(Rational(setup.planes.far), exact_distance(far_plane, origin, direction)) << i;
      }
      ASSERT_LT(setup.planes.near, kInfinity);
      ASSERT_GT(setup.planes.far, -kInfinity);
      ++axes;
    }
    if (::testing::Test::HasFailure()) break;
  }
  EXPECT_EQ(axes, 24'000U);
  EXPECT_GT(tight, 12'000U) << "most are within two last places";
}

/// A walk down nested boxes, and the exact planes of each.
struct Walk {
  std::array<Index, 3> lower{};
  std::array<int, 3> scale{};
  PlainPairTest test;
  std::array<float, 3> origin{};
  std::array<float, 3> direction{};
};

Walk start_walk(std::size_t case_class, int bits, Random& random) {
  Walk walk;
  const int common = random.between(-30, 20);
  walk.test.registers = {rtl::Scale(common - 30), rtl::UInt<1>(random.flip()), rtl::UInt<1>(random.flip())};
  rtl::RaySetupJob job;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    walk.scale[axis] = common + random.between(0, 3);
    walk.lower[axis] = random.between(-200, 200);
    const int cells = random.between(1, static_cast<int>(rules_of(walk.test.registers, bits).max_cells()));
    walk.test.node.grid[axis] = {walk.scale[axis], static_cast<int>(golden::modulo(walk.lower[axis], bits)), cells};
    job.root.lower[axis] = rtl::Float32::of(decoded_edge(walk.lower[axis], walk.scale[axis]));
    job.root.upper[axis] = rtl::Float32::of(decoded_edge(walk.lower[axis] + cells, walk.scale[axis]));
  }
  aim(case_class, job, random);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    walk.origin[axis] = job.origin[axis].value();
    walk.direction[axis] = job.direction[axis].value();
    const AxisSetup setup = set_up_axis(walk.origin[axis], walk.direction[axis], job.root.lower[axis].value(),
                                        job.root.upper[axis].value());
    walk.test.ray[axis] = setup.ray;
    walk.test.node.planes[axis] = setup.planes;
  }
  return walk;
}

using WalkCells = std::array<golden::Cells<Index>, 3>;

/// Two children anywhere in the node.
std::array<WalkCells, 2> add_children(Walk& walk, int bits, Random& random) {
  std::array<WalkCells, 2> cells{};
  for (std::size_t c = 0; c < 2; ++c) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const int most = walk.test.node.grid[axis].cells;
      const int margin = random.one_in(4) ? most - 1 : most / 4;
      const int lower = random.between(0, margin);
      const int upper = std::max(lower + 1, most - random.between(0, margin));
      cells[c][axis] = {walk.lower[axis] + lower, walk.lower[axis] + upper};
      walk.test.pair.child[c].codes[axis] =
          golden::encode_codes(cells[c][axis], walk.lower[axis], code_of(walk.test.registers), bits);
    }
  }
  return cells;
}

TEST(RayFaces, every_interval_down_nested_boxes_encloses_the_exact_one) {
  Random random(3);
  std::size_t planes = 0;
  std::size_t hits = 0;
  for (int i = 0; i < 600; ++i) {
    const int bits = 2 + i % 7;
    Walk walk = start_walk(static_cast<std::size_t>(i) % (kValidRays - 1), bits, random);
    for (int level = 0; level < 12; ++level) {
      const std::array<WalkCells, 2> cells = add_children(walk, bits, random);
      const PairTestAnswer answer = test_pair(walk.test, bits);
      ASSERT_EQ(answer.status, rtl::Status::ok);
      for (std::size_t c = 0; c < 2; ++c) {
        Rational entry = walk.test.t_min;
        Rational exit = Rational(kLargest) * Rational(kLargest);
        bool beside = false;
        for (std::size_t axis = 0; axis < 3; ++axis) {
          const double cell = std::ldexp(1.0, walk.scale[axis]);
          const double lower = static_cast<double>(cells[c][axis].lower) * cell;
          const double upper = static_cast<double>(cells[c][axis].upper) * cell;
          const float direction = walk.direction[axis];
          const Rational near = exact_distance(direction < 0 ? upper : lower, walk.origin[axis], direction);
          const Rational far = exact_distance(direction < 0 ? lower : upper, walk.origin[axis], direction);
          const PlainDistances found = answer.child[c].node.planes[axis];
          ASSERT_TRUE(std::isinf(found.near) ? found.near < 0 : Rational(found.near) <= near);
          ASSERT_TRUE(std::isinf(found.far) ? found.far > 0 : Rational(found.far) >= far);
          planes += 2;
          if (direction == 0) beside = beside || near > 0 || far < 0;
          if (direction != 0) {
            entry = std::max(entry, near);
            exit = std::min(exit, far);
          }
        }
        const bool exact_hit = !beside && entry <= exit;
        ASSERT_TRUE(answer.child[c].inside.hit || !exact_hit);
        hits += exact_hit;
      }
      const std::size_t next = answer.child[1].inside.hit ? 1 : 0;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const PlainGridAxis& grid = answer.child[next].node.grid[axis];
        walk.lower[axis] = cells[next][axis].lower * (Index{1} << (walk.scale[axis] - grid.scale));
        walk.scale[axis] = grid.scale;
        ASSERT_EQ(golden::modulo(walk.lower[axis], bits), grid.lower);
      }
      walk.test.node = answer.child[next].node;
    }
  }
  EXPECT_EQ(planes, 600U * 12 * 12);
  EXPECT_GT(hits, 300U);
}

/// Whether the exact ray meets the closed box of these cells between its ends.
bool meets(const rtl::RayJob& ray, const WalkCells& cells, const std::array<int, 3>& scale) {
  Rational entry = ray.t_min.value();
  const bool endless = std::isinf(ray.t_max.value());
  Rational exit = endless ? Rational(kLargest) * kLargest : Rational(ray.t_max.value());
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double cell = std::ldexp(1.0, scale[axis]);
    const float direction = ray.direction[axis].value();
    std::array<Rational, 2> ends;
    for (std::size_t side = 0; side < 2; ++side) {
      const auto index = static_cast<double>(side == 0 ? cells[axis].lower : cells[axis].upper);
      ends[side] = exact_distance(index * cell, ray.origin[axis].value(), direction);
    }
    if (direction < 0) std::swap(ends[0], ends[1]);
    if (direction == 0 && (ends[0] > 0 || ends[1] < 0)) return false;
    if (direction == 0) continue;
    entry = std::max(entry, ends[0]);
    exit = std::min(exit, ends[1]);
  }
  return entry <= exit;
}

/// First entries of the leaves whose boxes, and those of all nodes above, the exact ray meets.
void exact_leaves(const golden::CompressedTree& tree, const rtl::RayJob& ray, std::uint32_t pair,
                  const golden::Context<Index>& context, std::set<std::uint32_t>& leaves) {
  for (const golden::CompressedChild& child : tree.pairs[pair].child) {
    WalkCells cells{};
    std::array<int, 3> scale{};
    golden::Context<Index> own{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      scale[axis] = context[axis].scale;
      cells[axis] = golden::decode_codes(child.codes[axis], context[axis].lower, tree.code, tree.rules.bits);
      own[axis] = golden::own_context(cells[axis], scale[axis], tree.rules);
    }
    if (!meets(ray, cells, scale)) continue;
    if (child.leaf) {
      leaves.insert(child.pointer);
    } else {
      exact_leaves(tree, ray, child.pointer, own, leaves);
    }
  }
}

TEST(RayFaces, a_traversal_meets_every_leaf_that_the_exact_ray_meets_and_few_others) {
  Random random(4);
  std::size_t exact = 0;
  std::size_t met = 0;
  for (int i = 0; i < 600; ++i) {
    const int bits = 2 + i % 5;
    const std::size_t case_class = 1 + static_cast<std::size_t>(i) % 13;  // single-pair to stops
    const RayEpisode episode = make_ray_episode(case_class, random, bits);
    const PlainRayTree plain = plain_ray_tree(episode.tree);
    golden::Context<Index> root{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      root[axis] = {episode.tree.root[axis].scale, static_cast<Index>(episode.tree.root[axis].lower)};
    }
    for (const rtl::RayJob& ray : episode.rays) {
      std::set<std::uint32_t> wanted;
      exact_leaves(episode.tree, ray, plain.root, root, wanted);
      std::set<std::uint32_t> found;
      bool begins = true;
      const auto meet = [&](const PlainCandidate& candidate) {
        if (begins) found.insert(candidate.entry_index);
        begins = candidate.last_of_leaf;
      };
      const TraversedRay result = traverse(plain_ray(ray), plain, bits, meet, [] { return PlainReply(); });
      ASSERT_EQ(result.status, rtl::Status::ok);
      ASSERT_TRUE(std::includes(found.begin(), found.end(), wanted.begin(), wanted.end())) << i;
      exact += wanted.size();
      met += found.size();
    }
  }
  EXPECT_GT(exact, 1000U);
  EXPECT_LT(met, exact + exact / 4);
}

}  // namespace
}  // namespace cbvh::vectors
