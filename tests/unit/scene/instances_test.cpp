// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/scene/instances.h"

#include <gtest/gtest.h>

#include <bit>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <limits>

#include "golden/input_error.h"
#include "golden/quantize/edge.h"
#include "golden/scene/directed.h"
#include "golden/scene/procedural/random.h"
#include "golden/scene/trouble_scenes.h"

namespace cbvh::golden {
namespace {

using Rational = boost::multiprecision::cpp_rational;

/// Floats of many sizes, both signs, zeros and subnormals among them; finite products stay within binary32 if asked.
float any_float(Random& random, int largest_exponent) {
  const std::uint64_t bits = random.bits();
  if (bits % 16 == 0) return bits & 16 ? 0.0F : -0.0F;
  if (bits % 16 == 1) return std::bit_cast<float>(static_cast<std::uint32_t>(bits >> 32 & 0x807FFFFF));
  const float fraction = random.between(-2.0F, 2.0F);
  const auto span = static_cast<std::uint64_t>(bits % 16 < 12 ? 8 : largest_exponent + 140);
  return std::ldexp(fraction, largest_exponent - 1 - static_cast<int>(random.bits() % span));
}

glm::mat4 any_transform(Random& random) {
  glm::mat4 m(1.0F);
  for (glm::length_t column = 0; column < 4; ++column) {
    for (glm::length_t row = 0; row < 3; ++row) m[column][row] = any_float(random, column == 3 ? 120 : 55);
  }
  return m;
}

Rational image(const glm::mat4& m, const glm::vec3& p, glm::length_t row) {
  Rational sum = m[3][row];
  for (glm::length_t column = 0; column < 3; ++column) sum += Rational(m[column][row]) * Rational(p[column]);
  return sum;
}

std::string message_of(const TwoLevelScene& scene) {
  try {
    check_scene(scene);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

Mesh triangle() { return {"t", {{0, 0, 0}, {1, 0, 0}, {0, 1, 2}}, {{0, 1, 2}}}; }

TEST(Instances, directed_sums_are_the_exact_one_or_the_double_below_it) {
  Random random(5);
  const auto below = [](double x) { return std::nextafter(x, -INFINITY); };
  int checks = 0;
  for (int i = 0; i < 2000; ++i) {
    double a = random.between(-2, 2);
    if (i % 2 == 0) a = i % 4 == 0 ? -1.0 : 1.0;  // powers of two: other gaps on either side
    a = std::ldexp(a, static_cast<int>(random.bits() % 300) - 150);
    const double little = std::abs(a) * 0x1p-80;
    const Double2 sums = add_down(Double2{a, a}, Double2{-little, little});
    ASSERT_EQ(sums[0], below(a)) << i;
    ASSERT_EQ(sums[1], a) << i;
    const Double2 others = add_down(Double2{a, 0.0}, Double2{-a, a});
    ASSERT_EQ(others[0], 0.0) << i;
    ASSERT_EQ(others[1], a) << i;
    checks += 4;
  }
  EXPECT_EQ(checks, 8000);
}

TEST(Instances, floats_are_rounded_down_as_round_down_says) {
  Random random(6);
  constexpr double kMax = std::numeric_limits<float>::max();
  std::vector<double> values{0.0,      -0.0,      kMax,     -kMax,     kMax * 2, -kMax * 2,
                             0x1p-149, -0x1p-149, 0x1p-151, -0x1p-151, 1,        -1};
  for (int i = 0; i < 3000; ++i)
    values.push_back(std::ldexp(static_cast<double>(random.between(-2, 2)) + random.unit() * 0x1p-30,
                                static_cast<int>(random.bits() % 300) - 160));
  for (std::size_t i = 1; i < values.size(); ++i) {
    const std::array<float, 2> floats = floats_down(Double2{values[i - 1], values[i]});
    ASSERT_EQ(floats[0], round_down(values[i - 1])) << values[i - 1];
    ASSERT_EQ(floats[1], round_down(values[i])) << values[i];
  }
}

TEST(Instances, world_boxes_enclose_every_corner_exactly_and_are_at_most_a_float_too_wide) {
  Random random(1);
  std::size_t tight = 0;
  std::size_t sides = 0;
  for (int i = 0; i < 3000; ++i) {
    const glm::mat4 m = any_transform(random);
    Box box{};
    for (glm::length_t axis = 0; axis < 3; ++axis) {
      const float a = any_float(random, 60);
      const float b = any_float(random, 60);
      box.lower[axis] = std::min(a, b);
      box.upper[axis] = std::max(a, b);
    }
    const Box world = world_box(box, m);
    for (glm::length_t row = 0; row < 3; ++row) {
      Rational least = image(m, box.lower, row);
      Rational greatest = least;
      for (unsigned corner = 1; corner < 8; ++corner) {
        const glm::vec3 p{corner & 1 ? box.upper.x : box.lower.x, corner & 2 ? box.upper.y : box.lower.y,
                          corner & 4 ? box.upper.z : box.lower.z};
        const Rational x = image(m, p, row);
        least = std::min(least, x);
        greatest = std::max(greatest, x);
      }
      ASSERT_LE(Rational(world.lower[row]), least) << i;
      ASSERT_GE(Rational(world.upper[row]), greatest) << i;
      const float inward = std::nextafter(world.lower[row], std::numeric_limits<float>::infinity());
      tight += Rational(inward) > least ? 1U : 0U;
      ++sides;
    }
  }
  EXPECT_GT(tight * 100, sides * 95) << "almost always there is no tighter float";
}

TEST(Instances, images_of_nested_boxes_are_nested_and_hold_the_images_of_their_points) {
  Random random(2);
  for (int i = 0; i < 3000; ++i) {
    const glm::mat4 m = any_transform(random);
    Box outer{};
    Box inner{};
    for (glm::length_t axis = 0; axis < 3; ++axis) {
      std::array<float, 4> x;
      for (float& value : x) value = any_float(random, 60);
      std::sort(x.begin(), x.end());
      outer.lower[axis] = x[0];
      inner.lower[axis] = x[1];
      inner.upper[axis] = x[2];
      outer.upper[axis] = x[3];
    }
    const Box a = world_box(outer, m);
    const Box b = world_box(inner, m);
    const glm::vec3 p = world_point(inner.lower, m);
    for (glm::length_t axis = 0; axis < 3; ++axis) {
      ASSERT_LE(a.lower[axis], b.lower[axis]) << i;
      ASSERT_GE(a.upper[axis], b.upper[axis]) << i;
      ASSERT_LE(b.lower[axis], p[axis]) << i;
      ASSERT_GE(b.upper[axis], p[axis]) << i;
    }
  }
}

TEST(Instances, the_identity_changes_no_box_and_no_point) {
  for (std::uint64_t id = 0; id < 60; ++id) {
    const Mesh mesh = trouble_scene(kTroubles[id % kTroubles.size()], id);
    for (const glm::vec3& p : mesh.positions) {
      const Box world = world_box({p, p}, glm::mat4(1.0F));
      ASSERT_EQ(world.lower, p);
      ASSERT_EQ(world.upper, p);
      ASSERT_EQ(world_point(p, glm::mat4(1.0F)), p);
    }
  }
}

TEST(Instances, an_inverse_undoes_its_transform) {
  Random random(3);
  int checks = 0;
  for (int i = 0; i < 1000; ++i) {
    glm::mat4 m(1.0F);
    for (glm::length_t column = 0; column < 4; ++column) {
      for (glm::length_t row = 0; row < 3; ++row) m[column][row] = random.between(-1, 1);
    }
    const glm::dmat4 inverse = inverse_of(m, "m");
    const glm::dmat4 product = inverse * glm::dmat4(m);
    double largest = 1;  // of the inverse's entries
    for (glm::length_t c = 0; c < 4; ++c) {
      for (glm::length_t r = 0; r < 4; ++r) largest = std::max(largest, std::abs(inverse[c][r]));
    }
    for (glm::length_t c = 0; c < 4; ++c) {
      for (glm::length_t r = 0; r < 4; ++r) {
        ASSERT_LE(std::abs(product[c][r] - (c == r ? 1.0 : 0.0)), largest * largest * 0x1p-48) << i;
        ++checks;
      }
    }
  }
  EXPECT_EQ(checks, 16000);
}

TEST(Instances, by_hand_a_quarter_turn_with_translation) {
  glm::mat4 m(0.0F);  // x to y, y to -x
  m[0] = {0, 1, 0, 0};
  m[1] = {-1, 0, 0, 0};
  m[2] = {0, 0, 1, 0};
  m[3] = {10, 20, 30, 1};
  const Box world = world_box({{1, 2, 3}, {4, 6, 8}}, m);
  EXPECT_EQ(world.lower, glm::vec3(4, 21, 33));
  EXPECT_EQ(world.upper, glm::vec3(8, 24, 38));
  const Mesh flat = flatten({"s", {triangle()}, {{0}, {0, m}}});
  ASSERT_EQ(flat.triangles.size(), 2U);
  EXPECT_EQ(flat.triangles[1], glm::uvec3(3, 4, 5));
  EXPECT_EQ(flat.positions[4], glm::vec3(10, 21, 30));
  EXPECT_EQ(flat.positions[5], glm::vec3(9, 20, 32));
}

TEST(Instances, what_is_wrong_with_a_scene_is_said_with_its_place) {
  const auto with = [](glm::length_t column, glm::length_t row, float value) {
    TwoLevelScene scene{"s", {triangle()}, {{0}, {0}}};
    scene.instances[1].to_world[column][row] = value;
    return message_of(scene);
  };
  EXPECT_EQ(message_of({"s", {triangle()}, {{0}}}), "");
  EXPECT_EQ(message_of({"s", {triangle()}, {}}), "s: found no instances, wanted at least 1");
  EXPECT_EQ(message_of({"s", {triangle()}, {{0}, {1}}}),
            "s: instance 1: found object 1, wanted one of the 1 there are");
  EXPECT_EQ(message_of({"s", {}, {{0}}}), "s: instance 0: found object 0, wanted one of the 0 there are");
  EXPECT_EQ(message_of({"s", {triangle(), {}}, {{0}}}), "s: object 1: no triangles");
  EXPECT_EQ(with(1, 2, std::numeric_limits<float>::quiet_NaN()),
            "s: instance 1: transform, row 2, column 1: found nan, wanted a finite number");
  EXPECT_EQ(with(3, 0, -INFINITY), "s: instance 1: transform, row 0, column 3: found -inf, wanted a finite number");
  EXPECT_EQ(with(2, 3, 0.5F), "s: instance 1: transform, row 3, column 2: found 0.5, wanted 0");
  EXPECT_EQ(with(3, 3, 2.0F), "s: instance 1: transform, row 3, column 3: found 2, wanted 1");
  EXPECT_EQ(with(0, 0, 0.0F),
            "s: instance 1: transform: found one that is singular (determinant 0), wanted one that has an inverse");
  EXPECT_EQ(with(0, 0, 3e38F), "");
  EXPECT_EQ(with(2, 2, 3e38F), "s: instance 1: found coordinates beyond binary32 in the world, wanted finite ones");
}

TEST(Instances, a_transform_whose_determinant_only_rounds_away_from_zero_is_singular) {
  Random random(4);
  for (int i = 0; i < 200; ++i) {
    glm::mat4 m(1.0F);
    for (glm::length_t row = 0; row < 3; ++row) {
      m[0][row] = random.between(-1, 1);
      m[1][row] = m[0][row] * 0.25F;
      m[2][row] = random.between(-1, 1);
    }
    EXPECT_THROW(inverse_of(m, "m"), InputError);
  }
  EXPECT_NO_THROW(inverse_of({1e-30F, 0, 0, 0, 0, 1e30F, 0, 0, 0, 0, -1e-38F, 0, 0, 0, 0, 1}, "m"));
}

}  // namespace
}  // namespace cbvh::golden
