// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

/// Where a ray meets a plane, without rounding: t compared with the exact (plane - origin) / direction of floats, a
/// plane of a decoded box being a multiple of a power of two up to +-2^128. Some adds and a multiplication, so that
/// every box test of an image can be judged; against rationals in plane_distance_test.
namespace cbvh::golden {

/// plane - origin = sum + rest, exactly (Knuth's two-sum; 2^128 and floats are far from the ends of binary64).
struct ExactOffset {
  double sum;   ///< rounded to nearest
  double rest;  ///< at most half of sum's last place
};
inline ExactOffset exact_offset(double plane, double origin) {
  const double sum = plane - origin;
  const double of_origin = plane - sum;
  return {sum, (plane - (sum + of_origin)) - (origin - of_origin)};
}

/// Whether t * |direction| <= plane - origin, all three along the ray. The product of two floats is a double.
inline bool at_or_before(float t, double plane, double origin, double direction) {
  const double product = static_cast<double>(t) * direction;
  const ExactOffset offset = exact_offset(plane, origin);
  return product < offset.sum || (product == offset.sum && offset.rest >= 0);
}

/// Whether t is not after where the ray meets the plane. direction is not 0.
inline bool not_after_plane(float t, double plane, float origin, float direction) {
  const double sign = direction < 0 ? -1 : 1;
  return at_or_before(t, sign * plane, sign * static_cast<double>(origin), std::fabs(static_cast<double>(direction)));
}
/// Whether t is not before it.
inline bool not_before_plane(float t, double plane, float origin, float direction) {
  return not_after_plane(-t, -plane, -origin, direction);
}

}  // namespace cbvh::golden
