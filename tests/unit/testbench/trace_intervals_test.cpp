// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "golden/scene/load.h"
#include "testbench/trace/intervals/check_intervals.h"
#include "testbench/trace/intervals/interval_tracer.h"

namespace cbvh::testbench {
namespace {

const golden::Ray kRay{{0, 1, -4}, {0.5F, 0, 3}};
const ExactBox kBox{{1, -2, 5}, {2, 3, 1e30}};

std::array<rtl::PlaneDistances, 3> planes(std::array<std::array<float, 2>, 3> distances) {
  std::array<rtl::PlaneDistances, 3> result;
  for (std::size_t axis = 0; axis < 3; ++axis)
    result[axis] = {rtl::Float32::of(distances[axis][0]), rtl::Float32::of(distances[axis][1])};
  return result;
}

std::string violation(const std::array<std::array<float, 2>, 3>& distances) {
  try {
    check_planes(kRay, kBox, planes(distances), {7, 1});
  } catch (const IntervalViolation& found) {
    return found.what();
  }
  return "";
}

TEST(Intervals, one_unit_in_the_last_place_beside_an_exact_distance_is_a_violation) {
  // x: planes at t = 2 and 4; y: parallel, offsets -3 and 2; z: (1e30 + 4) / 3 is no float.
  const float far = std::nextafter(1e30F / 3, INFINITY);
  const std::array<std::array<float, 2>, 3> exact = {{{2, 4}, {-3, 2}, {3, far}}};
  EXPECT_EQ(violation(exact), "");
  const auto changed = [&](std::size_t axis, std::size_t end, float towards) {
    auto distances = exact;
    distances[axis][end] = std::nextafter(distances[axis][end], towards);
    return violation(distances);
  };
  for (std::size_t axis = 0; axis < 3; ++axis) {
    EXPECT_EQ(changed(axis, 0, -INFINITY), "");
    EXPECT_EQ(changed(axis, 1, INFINITY), "");
    EXPECT_NE(changed(axis, 0, INFINITY), "") << axis;
  }
  EXPECT_NE(changed(0, 1, -INFINITY), "");
  EXPECT_NE(changed(1, 1, -INFINITY), "");
  EXPECT_NE(violation({{{2, 4}, {-3, 2}, {3, std::nextafter(std::nextafter(far, 0.0F), 0.0F)}}}), "");
  EXPECT_EQ(changed(0, 0, INFINITY).substr(0, 66),
            "ray 0,1,-4,0.5,0,3,0,inf, child 1 of pair 7, x: the unit's 2.00000");
}

TEST(Intervals, every_interval_of_a_picture_encloses_the_exact_one_for_every_n) {
  const golden::Mesh mesh = golden::load_scene("proc:spheres,triangles=2000");
  for (int bits = 2; bits <= 8; bits += 2) {
    for (const golden::Code code : {golden::Code::modulo, golden::Code::relative}) {
      const TreePair trees =
          build_and_compress(mesh, {.scene = "", .bits = bits, .code = code, .compression = Compression::top_down});
      const PictureJob job{.camera = "inside", .rays = golden::RayKind::path, .samples = 1, .width = 24, .height = 18};
      const IntervalsResult result = check_intervals(mesh, trees.compressed, job);
      ASSERT_TRUE(result.failures.empty()) << "N = " << bits << ": " << result.failures.front();
      EXPECT_GT(result.box_tests, 5000U);
      EXPECT_GE(result.box_tests, result.golden_box_tests);
    }
  }
}

TEST(Intervals, a_wrong_code_on_the_way_ends_the_run_with_ray_and_node) {
  const golden::Mesh mesh = golden::load_scene("proc:spheres,triangles=2000");
  golden::CompressedTree tree =
      build_and_compress(mesh, {.scene = "", .compression = Compression::top_down}).compressed;
  tree.scene.upper -= 0.25F;  // the codes are relative to the cells of a larger box
  const IntervalsResult result =
      check_intervals(mesh, tree, {.camera = "inside", .width = 24, .height = 18, .threads = 1});
  ASSERT_EQ(result.failures.size(), 1U);
  EXPECT_NE(result.failures[0].find("ray "), std::string::npos);
}

}  // namespace
}  // namespace cbvh::testbench
