// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/trace/exact_triangle.h"

#include <gtest/gtest.h>

#include "golden/trace/random.h"
#include "golden/trace/triangle.h"

namespace cbvh::golden {
namespace {

using Rational = boost::multiprecision::cpp_rational;

Rational value(const ExactDistance& t) { return Rational(t.numerator, t.denominator); }

/// Cramer's rule in rationals: o + t d = a + beta (b - a) + gamma (c - a).
std::optional<Rational> by_cramer(const Ray& ray, const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
  using Column = std::array<Rational, 3>;
  const auto difference = [](const glm::vec3& x, const glm::vec3& y) {
    Column column;
    for (int axis = 0; axis < 3; ++axis) column[static_cast<std::size_t>(axis)] = Rational(x[axis]) - Rational(y[axis]);
    return column;
  };
  const auto determinant = [](const Column& x, const Column& y, const Column& z) -> Rational {
    return x[0] * (y[1] * z[2] - y[2] * z[1]) - y[0] * (x[1] * z[2] - x[2] * z[1]) + z[0] * (x[1] * y[2] - x[2] * y[1]);
  };
  const Column x = difference(a, b);
  const Column y = difference(a, c);
  const Column z = difference(ray.direction, glm::vec3(0));
  const Column right = difference(a, ray.origin);
  const Rational all = determinant(x, y, z);
  if (all == 0) return std::nullopt;
  const Rational beta = determinant(right, y, z) / all;
  const Rational gamma = determinant(x, right, z) / all;
  const Rational t = determinant(x, y, right) / all;
  if (beta < 0 || gamma < 0 || beta + gamma > 1) return std::nullopt;
  if (t < Rational(ray.t_min) || (!std::isinf(ray.t_max) && t > Rational(ray.t_max))) return std::nullopt;
  return t;
}

TEST(ExactTriangle, hits_are_those_of_cramers_rule_in_rationals) {
  std::size_t hits = 0;
  std::size_t misses = 0;
  for (std::uint64_t i = 0; i < 6000; ++i) {
    CounterRandom random(i, 0, 0);
    // Few values, so that edges, vertices and planes are met; of all magnitudes, so that scales differ.
    const auto coordinate = [&](int most) {
      const double whole = std::floor(random.next() * (2 * most + 1)) - most;
      return static_cast<float>(std::ldexp(whole, i % 3 == 0 ? static_cast<int>(random.next() * 40) - 20 : 0));
    };
    const auto point = [&](int most) { return glm::vec3(coordinate(most), coordinate(most), coordinate(most)); };
    Ray ray{point(3), point(2)};
    if (ray.direction == glm::vec3(0)) ray.direction.x = 1;
    ray.t_min = static_cast<float>(i % 2);
    if (i % 5 == 0) ray.t_max = 2;
    const glm::vec3 a = point(3);
    const glm::vec3 b = point(3);
    const glm::vec3 c = point(3);
    const std::optional<Rational> wanted = by_cramer(ray, a, b, c);
    const std::optional<ExactDistance> found = exact_hit(ray, a, b, c);
    ASSERT_EQ(found.has_value(), wanted.has_value()) << i;
    ++(wanted ? hits : misses);
    if (!wanted) continue;
    ASSERT_EQ(value(*found), *wanted) << i;
    ASSERT_GT(found->denominator, 0);
    const auto nearest = static_cast<double>(*wanted);
    ASSERT_EQ(compare(*found, nearest), wanted->compare(Rational(nearest))) << i;
    ASSERT_EQ(value(distance_between(*found, nearest)), abs(Rational(*wanted - Rational(nearest)))) << i;
    ASSERT_EQ(compare(*found, *found), 0);
    ASSERT_EQ(compare(*found, std::numeric_limits<double>::infinity()), -1);
  }
  EXPECT_GT(hits, 200U);
  EXPECT_GT(misses, 3000U);
}

TEST(ExactTriangle, corners_and_edges_belong_to_it_and_what_lies_beside_by_one_unit_does_not) {
  const glm::vec3 a(0, 0, 1);
  const glm::vec3 b(1, 0, 1);
  const glm::vec3 c(0, 1, 1);
  const auto hit = [&](float x, float y) { return exact_hit({{x, y, 0}, {0, 0, 1}}, a, b, c).has_value(); };
  EXPECT_TRUE(hit(0, 0));
  EXPECT_TRUE(hit(1, 0));
  EXPECT_TRUE(hit(0.25F, 0.75F));
  EXPECT_FALSE(hit(0.25F, std::nextafter(0.75F, 1.0F)));
  EXPECT_FALSE(hit(-0x1p-149F, 0));
  EXPECT_FALSE(exact_hit({{0, 0, 1}, {1, 0, 0}}, a, b, c)) << "in its plane";
  EXPECT_FALSE(exact_hit({{0, 0, 0}, {0, 0, 1}}, a, a, c)) << "without area";
}

TEST(ExactTriangle, the_tracers_test_hits_exactly_what_is_hit_also_at_edges_and_vertices) {
  std::size_t hits = 0;
  std::size_t at_edges = 0;
  for (std::uint64_t i = 0; i < 20000; ++i) {
    CounterRandom random(i, 1, 0);
    const float size = i % 4 == 0 ? 0x1p-20F : 1;
    const auto point = [&](double scale) {
      const auto coordinate = [&] {
        const double any = (2 * random.next() - 1) * scale;
        return static_cast<float>(i % 4 == 1 ? std::round(any * 256) / 256 : any);  // differences are exact
      };
      const float x = coordinate();
      const float y = coordinate();
      return glm::vec3(x, y, coordinate());
    };
    const glm::vec3 near = point(1);
    const std::array<glm::vec3, 3> corners{near, near + point(size), near + point(size)};
    const glm::vec3& a = corners[i % 3];
    const glm::vec3& b = corners[(i + 1) % 3];
    const glm::vec3 target = i % 5 == 0   ? a
                             : i % 5 == 1 ? (a + b) * 0.5F
                                          : a + (b - a) * static_cast<float>(random.next());
    Ray ray{point(2), glm::vec3(0)};
    ray.direction = target - ray.origin;
    const std::optional<ExactDistance> wanted = exact_line_hit(widened(ray), corners[0], corners[1], corners[2]);
    const std::optional<double> found = TriangleTest(ray)(corners[0], corners[1], corners[2]);
    ASSERT_EQ(found.has_value(), wanted.has_value()) << i;
    if (!wanted) continue;
    ++hits;
    ASSERT_NEAR(*found, rounded(*wanted), 1e-6) << i;
    if (*found == rounded(*wanted) && compare(*wanted, 1.0) == 0) ++at_edges;
  }
  EXPECT_GT(hits, 5000U);
  EXPECT_GT(at_edges, 500U);
}

TEST(ExactTriangle, distances_of_other_triangles_compare_as_numbers) {
  const Ray ray{{0.25F, 0.25F, 0}, {0, 0, 3}};
  const auto at = [&](float z) { return *exact_hit(ray, {0, 0, z}, {1, 0, z}, {0, 1, z}); };
  EXPECT_EQ(compare(at(1), at(std::nextafter(1.0F, 2.0F))), -1);
  EXPECT_EQ(compare(at(0x1p100F), at(1)), 1);
  EXPECT_EQ(compare(at(1), *exact_hit(ray, {0, 0, 1}, {8, 0, 1}, {0, 8, 1})), 0);
}

}  // namespace
}  // namespace cbvh::golden
