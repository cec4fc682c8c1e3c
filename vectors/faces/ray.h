// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <limits>

#include "golden/quantize/grid.h"
#include "golden/tree/compressed_tree.h"
#include "vectors/payloads.h"

/// The golden's answer for rays and the children of a pair, in plain numbers.
namespace cbvh::vectors {

/// A ray against the planes of one axis of a box.
struct PlainDistances {
  float near;
  float far;
  bool operator==(const PlainDistances&) const = default;
};
struct PlainRayAxis {
  float inverse;
  bool backwards;
  bool parallel;
  bool operator==(const PlainRayAxis&) const = default;
};

struct AxisSetup {
  PlainRayAxis ray;
  PlainDistances planes;
};

/// One axis of a ray and of the root's box [lower, upper], with +-infinity for +-2^128. inverse: the largest float that
/// is not above 1 / |direction|. Distances: the offset to the plane, rounded away from the box, times 1 / |direction|,
/// rounded to a float so that the product grows away from the box, and then once more that way. Parallel to the axis's
/// planes, the offsets themselves, and 1.
AxisSetup set_up_axis(float origin, float direction, float lower, float upper);

/// What refuses an axis of a ray: not_finite, inverted or ok.
rtl::Status setup_status(float origin, float direction, float lower, float upper);

/// A node's own grid, and how much of it the node spans.
struct PlainGridAxis {
  int scale;
  int lower;  ///< modulo 2^N
  int cells;
  bool operator==(const PlainGridAxis&) const = default;
};

struct PlainReachedNode {
  std::array<PlainGridAxis, 3> grid;
  std::array<PlainDistances, 3> planes;
};

struct PlainPairTest {
  golden::CompressedPair pair;
  PlainReachedNode node;
  std::array<PlainRayAxis, 3> ray;
  float t_min = 0;
  float t_max = std::numeric_limits<float>::infinity();
  rtl::SceneRegisters registers;
};

/// Where a ray is inside a box, by the slabs test; of equal ends the ray's own.
struct BoxInterval {
  bool hit = false;
  float entry = 0;
  float exit = 0;
};
BoxInterval box_interval(const std::array<PlainDistances, 3>& planes, const std::array<PlainRayAxis, 3>& ray,
                         float t_min, float t_max);

struct TestedBox {
  BoxInterval inside;
  PlainReachedNode node{};
};

struct PairTestAnswer {
  rtl::Status status = rtl::Status::ok;  ///< everything else is zero when it is not ok
  std::array<TestedBox, 2> child;
  bool second_first = false;
};

/// Rules 4 and 5 from the parent's planes inwards (docs/arithmetic.md, rule 11). Refused, the first that applies:
/// not_finite (what no setup gives), inverted, scale_below_minimum, too_wide (more cells than its grid or its parent
/// has).
PairTestAnswer test_pair(const PlainPairTest& test, int bits);

}  // namespace cbvh::vectors
