// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "vectors/faces/axis.h"
#include "vectors/generate/axis_jobs.h"
#include "vectors/unit.h"

namespace cbvh::vectors {

/// One axis of one child: two floats and a scale to codes, own grid and decoded bounds. Codes are always modulo.
template <int N>
struct AxisCompressor : StatelessUnit<AxisCompressor<N>, rtl::AxisJob, rtl::AxisResult<N>> {
  static constexpr std::string_view kName = "axis_compressor";
  static constexpr std::string_view kSummary = "one axis of a child: two floats and a scale to codes and the own grid";
  static constexpr std::string_view kLatencyText = "3";
  static constexpr std::uint32_t kLatency = 3;
  static constexpr const auto& kClasses = kAxisJobClasses;

  static rtl::AxisJob generate_one(std::size_t case_class, Random& random, const Parameters& parameters) {
    return make_axis_job(case_class, random, parameters.bits);
  }

  static rtl::AxisResult<N> respond_one(const rtl::AxisJob& job, const Parameters&) {
    const int scale = static_cast<int>(job.scale.value());
    const AxisAnswer answer = compress_axis(job.lower.value(), job.upper.value(), scale, job.registers, N);
    rtl::AxisResult<N> result;
    result.status = rtl::StatusBits(static_cast<std::uint64_t>(answer.status));
    if (answer.status != rtl::Status::ok) return result;
    const golden::AxisCodes codes = golden::encode_codes(answer.cells, Index{0}, golden::Code::modulo, N);
    result.code_lo = rtl::UInt<N>(codes.lower);
    result.code_hi = rtl::UInt<N>(codes.upper);
    result.own_scale = rtl::Scale(answer.own.scale);
    result.own_lower = rtl::CellIndex(answer.own.lower);
    result.edge_lo = rtl::Float32::of(decoded_edge(answer.cells.lower, scale));
    result.edge_hi = rtl::Float32::of(decoded_edge(answer.cells.upper, scale));
    return result;
  }
};

}  // namespace cbvh::vectors
