// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "vectors/generate/axis_jobs.h"

#include "vectors/generate/intervals.h"

namespace cbvh::vectors {
namespace {

enum Refusal : std::size_t { kNotFinite = kIntervalCorners, kInverted, kBeyondExactness, kScaleBelowMinimum, kTooWide };

Interval any_valid(Random& random, int bits) {
  return make_interval(static_cast<IntervalCorner>(random.below(kIntervalCorners)), random, bits);
}

rtl::SceneRegisters any_registers(Random& random) {
  return {rtl::Scale::of_raw(random.next()), rtl::UInt<1>(random.flip()), rtl::UInt<1>(random.flip())};
}

/// Valid, or refused for its bounds or its minimum scale.
Interval interval_of_class(std::size_t case_class, Random& random, int bits) {
  if (case_class < kIntervalCorners) return make_interval(static_cast<IntervalCorner>(case_class), random, bits);
  Interval interval = any_valid(random, bits);
  if (case_class == kNotFinite) return with_special(interval, random);
  if (case_class == kInverted) return inverted(interval, random);
  interval.registers = too_fine_for(interval, random);
  return interval;
}

rtl::AxisJob axis_job_of(const Interval& interval) {
  return {rtl::Float32::of(interval.lower), rtl::Float32::of(interval.upper), rtl::Scale(interval.scale),
          interval.registers};
}

}  // namespace

rtl::AxisJob make_axis_job(std::size_t case_class, Random& random, int bits) {
  if (case_class == kAxisJobClasses.size() - 1) {
    return {rtl::Float32::of_raw(random.next()), rtl::Float32::of_raw(random.next()), rtl::Scale::of_raw(random.next()),
            any_registers(random)};
  }
  if (case_class == kTooWide) return axis_job_of(make_too_wide(random, bits));
  if (case_class == kScaleBelowMinimum) {
    Interval interval = any_valid(random, bits);
    interval.scale = static_cast<int>(interval.registers.min_scale.value()) - 1;
    if (random.flip()) interval.scale -= random.between(0, 60);
    return axis_job_of(interval);
  }
  return axis_job_of(interval_of_class(case_class, random, bits));
}

rtl::EstimateJob make_estimate_job(std::size_t case_class, Random& random, int bits) {
  if (case_class == kEstimateJobClasses.size() - 1) {
    return {rtl::Float32::of_raw(random.next()), rtl::Float32::of_raw(random.next()), any_registers(random)};
  }
  const Interval interval = interval_of_class(case_class, random, bits);
  return {rtl::Float32::of(interval.lower), rtl::Float32::of(interval.upper), interval.registers};
}

}  // namespace cbvh::vectors
