// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "vectors/generate/ray_setup_jobs.h"
#include "vectors/ray_convert.h"
#include "vectors/unit.h"

namespace cbvh::vectors {

/// Directions to reciprocals, and the planes of the root's box to distances along the ray.
struct RaySetter : StatelessUnit<RaySetter, rtl::RaySetupJob, rtl::RaySetupResult> {
  static constexpr std::string_view kName = "ray_setter";
  static constexpr std::string_view kSummary = "a ray to reciprocals and its distances to the planes of the root's box";
  static constexpr std::string_view kLatencyText = "32";
  static constexpr std::uint32_t kLatency = 32;
  static constexpr const auto& kClasses = kRaySetupClasses;

  static rtl::RaySetupJob generate_one(std::size_t case_class, Random& random, const Parameters&) {
    return make_ray_setup_job(case_class, random);
  }

  static rtl::RaySetupResult respond_one(const rtl::RaySetupJob& job, const Parameters&) {
    rtl::Status status = rtl::Status::ok;
    const auto axis_of = [&](std::size_t axis, auto&& f) {
      return f(job.origin[axis].value(), job.direction[axis].value(), job.root.lower[axis].value(),
               job.root.upper[axis].value());
    };
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const rtl::Status found = axis_of(axis, setup_status);
      if (found != rtl::Status::ok && (status == rtl::Status::ok || found < status)) status = found;
    }
    rtl::RaySetupResult result;
    result.status = rtl::StatusBits(static_cast<std::uint64_t>(status));
    if (status != rtl::Status::ok) return result;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const AxisSetup setup = axis_of(axis, set_up_axis);
      result.ray[axis] = to_wires(setup.ray);
      result.planes[axis] = to_wires(setup.planes);
    }
    return result;
  }
};

}  // namespace cbvh::vectors
