// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/trace/exact_triangle.h"

#include <array>
#include <bit>
#include <cmath>
#include <initializer_list>

namespace cbvh::golden {
namespace {

using Integer = boost::multiprecision::cpp_int;
using Vector = std::array<Integer, 3>;

constexpr int kFraction = 53;  ///< bits of a double's fraction

/// A finite double is value * 2^exponent.
struct Parts {
  std::int64_t value;
  int exponent;
};

Parts parts_of(double x) {
  int exponent = 0;
  const double fraction = std::frexp(x, &exponent);
  return {static_cast<std::int64_t>(std::ldexp(fraction, kFraction)), exponent - kFraction};
}

Integer shifted(const Integer& x, int exponent) { return x << static_cast<unsigned>(exponent); }

/// The largest power of two of which all coordinates are multiples; 0 if all are 0.
int common_exponent(std::initializer_list<glm::dvec3> vectors) {
  int least = std::numeric_limits<int>::max();
  for (const glm::dvec3& v : vectors) {
    for (int axis = 0; axis < 3; ++axis) {
      const Parts parts = parts_of(v[axis]);
      if (parts.value != 0)
        least = std::min(least, parts.exponent + std::countr_zero(static_cast<std::uint64_t>(parts.value)));
    }
  }
  return least == std::numeric_limits<int>::max() ? 0 : least;
}

/// In units of 2^exponent, of which every coordinate is a multiple.
Vector in_units(const glm::dvec3& v, int exponent) {
  Vector result;
  for (int axis = 0; axis < 3; ++axis) {
    const Parts parts = parts_of(v[axis]);
    const int shift = parts.exponent - exponent;
    Integer& to = result[static_cast<std::size_t>(axis)];
    if (shift >= 0) {
      to = shifted(parts.value, shift);
    } else if (parts.value != 0) {
      to = parts.value >> static_cast<unsigned>(-shift);  // a multiple: no bit that counts is lost
    }
  }
  return result;
}

Vector operator-(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Integer dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

ExactDistance exactly(double x) {
  const Parts parts = parts_of(x);
  if (parts.exponent >= 0) return {shifted(parts.value, parts.exponent), 1};
  return {parts.value, shifted(1, -parts.exponent)};
}

}  // namespace

int compare(const ExactDistance& a, const ExactDistance& b) {
  return Integer(a.numerator * b.denominator - b.numerator * a.denominator).sign();
}

int compare(const ExactDistance& a, double b) {
  if (std::isinf(b)) return b > 0 ? -1 : 1;
  return compare(a, exactly(b));
}

ExactDistance distance_between(const ExactDistance& a, double b) {
  const ExactDistance exact = exactly(b);
  return {abs(Integer(a.numerator * exact.denominator - exact.numerator * a.denominator)),
          a.denominator * exact.denominator};
}

double rounded(const ExactDistance& t) {
  return boost::multiprecision::cpp_rational(t.numerator, t.denominator).convert_to<double>();
}

std::optional<ExactDistance> exact_line_hit(const WideRay& ray, const glm::vec3& a, const glm::vec3& b,
                                            const glm::vec3& c) {
  const int place = common_exponent({ray.origin, a, b, c});
  const int slope = common_exponent({ray.direction});
  const Vector origin = in_units(ray.origin, place);
  const Vector direction = in_units(ray.direction, slope);
  const Vector p = in_units(a, place) - origin;
  const Vector q = in_units(b, place) - origin;
  const Vector r = in_units(c, place) - origin;
  const Integer u = dot(direction, cross(r, q));
  const Integer v = dot(direction, cross(p, r));
  const Integer w = dot(direction, cross(q, p));
  if ((u < 0 || v < 0 || w < 0) && (u > 0 || v > 0 || w > 0)) return std::nullopt;
  const Vector normal = cross(q - p, r - p);
  ExactDistance t{dot(normal, p), dot(normal, direction)};
  if (t.denominator == 0) return std::nullopt;
  if (t.denominator < 0) t = {-t.numerator, -t.denominator};
  const int scale = place - slope;
  (scale >= 0 ? t.numerator : t.denominator) <<= static_cast<unsigned>(std::abs(scale));
  return t;
}

std::optional<ExactDistance> exact_hit(const Ray& ray, const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
  std::optional<ExactDistance> t = exact_line_hit(widened(ray), a, b, c);
  if (!t || compare(*t, static_cast<double>(ray.t_min)) < 0 || compare(*t, static_cast<double>(ray.t_max)) > 0)
    return std::nullopt;
  return t;
}

}  // namespace cbvh::golden
