// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "vectors/faces/axis.h"
#include "vectors/generate/axis_jobs.h"
#include "vectors/unit.h"

namespace cbvh::vectors {

/// Rule 6 for one axis: the grid a node would have as the root. The payloads are the same for every N, the answers are
/// not.
template <int N>
struct ScaleEstimator : StatelessUnit<ScaleEstimator<N>, rtl::EstimateJob, rtl::EstimateResult> {
  static constexpr std::string_view kName = "scale_estimator";
  static constexpr std::string_view kSummary = "one axis of a node's box to the grid it would have as the root";
  static constexpr std::string_view kLatencyText = "3";
  static constexpr std::uint32_t kLatency = 3;
  static constexpr const auto& kClasses = kEstimateJobClasses;

  static rtl::EstimateJob generate_one(std::size_t case_class, Random& random, const Parameters& parameters) {
    return make_estimate_job(case_class, random, parameters.bits);
  }

  static rtl::EstimateResult respond_one(const rtl::EstimateJob& job, const Parameters&) {
    const float lower = job.lower.value();
    const float upper = job.upper.value();
    rtl::EstimateResult result;
    const rtl::Status status = interval_status(lower, upper, job.registers);
    result.status = rtl::StatusBits(static_cast<std::uint64_t>(status));
    if (status != rtl::Status::ok) return result;
    const auto [scale, index] = golden::root_context<Index>(lower, upper, rules_of(job.registers, N));
    result.scale = rtl::Scale(scale);
    result.lower = rtl::CellIndex(index);
    return result;
  }
};

}  // namespace cbvh::vectors
