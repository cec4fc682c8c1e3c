// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "vectors/generate/ray_setup_jobs.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "vectors/generate/floats.h"

namespace cbvh::vectors {
namespace {

enum Class : std::size_t {
  kTowardsBox,
  kAxisParallel,
  kAllParallel,
  kBackwards,
  kOriginInFace,
  kOriginInside,
  kDegenerateBox,
  kTinyDirection,
  kHugeBox,
  kFarApart,
  kPowerOfTwo,
  kSubnormalOffset,
  kInfiniteEdge,
  kNotFinite,
  kInverted
};

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kLargest = std::numeric_limits<float>::max();

using rtl::Float32;

float of_size(int exponent, Random& random) {
  const float fraction = 1 + random.unit();
  return any_sign(std::ldexp(fraction, exponent), random);
}

void set_box(rtl::RaySetupJob& job, std::size_t axis, float a, float b) {
  job.root.lower[axis] = Float32::of(std::min(a, b));
  job.root.upper[axis] = Float32::of(std::max(a, b));
}

/// A point between the bounds, or in one of them.
float point_within(float lower, float upper, Random& random) {
  const double low = std::max(lower, -kLargest);
  const double high = std::min(upper, kLargest);
  const auto point = static_cast<float>(low + (high - low) * static_cast<double>(random.unit()));
  return std::clamp(point, static_cast<float>(low), static_cast<float>(high));
}

void make_box(std::size_t case_class, rtl::RaySetupJob& job, Random& random) {
  const int size = random.between(-20, 20);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const float a = float_within(std::ldexp(1.0F, size), random);
    const float b = float_within(std::ldexp(1.0F, size), random);
    set_box(job, axis, a, b);
    if (case_class == kDegenerateBox && random.flip()) set_box(job, axis, a, random.flip() ? a : std::nextafter(a, b));
    if (case_class == kHugeBox) {
      const float huge = any_huge_float(random);
      set_box(job, axis, huge, random.flip() ? a : any_huge_float(random));
    }
    if (case_class == kFarApart) {
      const int near = random.between(-140, 126);
      const float first = of_size(near, random);
      set_box(job, axis, first, of_size(random.between(-140, 126), random));
    }
    if (case_class == kSubnormalOffset) {
      const float tiny = any_tiny_float(random);
      set_box(job, axis, tiny, any_tiny_float(random));
    }
    if (case_class == kInfiniteEdge) {
      const std::uint64_t edges = 1 + random.below(3);
      if ((edges & 1) != 0) job.root.lower[axis] = Float32::of(-kInfinity);
      if ((edges & 2) != 0) job.root.upper[axis] = Float32::of(kInfinity);
    }
  }
}

void spoil(rtl::RaySetupJob& job, bool invert, Random& random) {
  const std::size_t axis = random.below(3);
  Float32& lower = job.root.lower[axis];
  Float32& upper = job.root.upper[axis];
  if (invert) {
    if (lower == upper) upper = Float32::of(std::nextafter(lower.value(), kInfinity));
    std::swap(lower, upper);
    return;
  }
  switch (random.below(6)) {
    case 0:
      job.origin[axis] = Float32::of(any_special_float(random));
      break;
    case 1:
      job.direction[axis] = Float32::of(any_special_float(random));
      break;
    case 2:
      lower = Float32::of(kInfinity);
      break;
    case 3:
      upper = Float32::of(-kInfinity);
      break;
    case 4:
      lower = Float32::of(std::numeric_limits<float>::quiet_NaN());
      break;
    default:
      upper = Float32::of_raw(0x7F800001 | random.below(2) << 31);
  }
}

float direction_of(std::size_t case_class, float towards, std::size_t free_axis, std::size_t axis, Random& random) {
  switch (case_class) {
    case kAxisParallel:
      return axis != free_axis && random.below(3) != 0 ? any_zero(random) : towards;
    case kAllParallel:
      return any_zero(random);
    case kBackwards:
      return -std::fabs(towards);
    case kTinyDirection:
      return any_tiny_float(random);
    case kFarApart:
      return of_size(random.between(-140, 126), random);
    case kPowerOfTwo:
      return any_sign(std::ldexp(1.0F, random.between(-149, 127)), random);
    default:
      return towards;
  }
}

}  // namespace

void aim(std::size_t case_class, rtl::RaySetupJob& job, Random& random) {
  const bool inside = case_class == kOriginInside || (case_class == kAxisParallel && random.flip());
  const std::size_t free_axis = random.below(3);
  const float reach = 1 + random.unit() * 4;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const float lower = job.root.lower[axis].value();
    const float upper = job.root.upper[axis].value();
    const float target = point_within(lower, upper, random);
    const float size = std::min(std::max(std::fabs(lower), std::fabs(upper)), kLargest);
    float origin = inside ? point_within(lower, upper, random) : float_within(size / 4, random) * reach;
    const bool in_face = case_class == kOriginInFace ? random.flip() : random.one_in(16);
    if (in_face) origin = random.flip() ? lower : upper;
    origin = std::clamp(origin, -kLargest, kLargest);
    if (case_class == kSubnormalOffset && random.flip()) origin = any_tiny_float(random);
    if (case_class == kFarApart && random.flip()) origin = of_size(random.between(-140, 126), random);
    float towards = std::clamp(target - origin, -kLargest, kLargest);
    if (random.flip()) towards = float_within(1, random);
    job.origin[axis] = Float32::of(origin);
    job.direction[axis] = Float32::of(direction_of(case_class, towards, free_axis, axis, random));
  }
}

rtl::RaySetupJob make_ray_setup_job(std::size_t case_class, Random& random) {
  rtl::RaySetupJob job;
  const bool spoiled = case_class >= kValidRays;
  const std::size_t valid = spoiled ? random.below(kValidRays) : case_class;
  make_box(valid, job, random);
  aim(valid, job, random);
  if (case_class == kNotFinite || case_class == kInverted) {
    spoil(job, case_class == kInverted, random);
  } else if (spoiled) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      job.origin[axis] = Float32::of_raw(random.next());
      job.direction[axis] = Float32::of_raw(random.next());
      job.root.lower[axis] = Float32::of_raw(random.next());
      job.root.upper[axis] = Float32::of_raw(random.next());
      if (random.flip() && job.root.upper[axis].value() < job.root.lower[axis].value()) {
        std::swap(job.root.upper[axis], job.root.lower[axis]);
      }
    }
  }
  return job;
}

}  // namespace cbvh::vectors
