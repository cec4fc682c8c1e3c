// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <boost/multiprecision/cpp_int.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "golden/trace/ray.h"

namespace cbvh::golden {

/// Where a ray hits a triangle, exactly: t = numerator / denominator, the denominator above 0. Equal t of one ray may
/// have other numerators.
struct ExactDistance {
  boost::multiprecision::cpp_int numerator;
  boost::multiprecision::cpp_int denominator;
};

/// -1, 0 or 1: whether a is less than, equal to or greater than b.
int compare(const ExactDistance& a, const ExactDistance& b);
int compare(const ExactDistance& a, double b);

/// How far apart a double and an exact distance are, exactly.
ExactDistance distance_between(const ExactDistance& a, double b);

/// The nearest double.
double rounded(const ExactDistance& t);

/// Whether a ray's line hits a triangle, in integers of any size: nothing rounds. Edges and vertices belong to the
/// triangle; a triangle without area, and one whose plane the ray is parallel to, is not hit.
std::optional<ExactDistance> exact_line_hit(const WideRay& ray, const glm::vec3& a, const glm::vec3& b,
                                            const glm::vec3& c);

/// The same of a ray, between t_min and t_max. The ray must pass check_ray.
std::optional<ExactDistance> exact_hit(const Ray& ray, const glm::vec3& a, const glm::vec3& b, const glm::vec3& c);

}  // namespace cbvh::golden
