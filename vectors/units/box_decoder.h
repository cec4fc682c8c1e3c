// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "vectors/faces/box_decode.h"
#include "vectors/generate/decode_jobs.h"
#include "vectors/unit.h"

namespace cbvh::vectors {

/// One child of a stored pair and its parent's context to its box in binary32 and its own context. Codes are modulo or
/// relative.
template <int N>
struct BoxDecoder : StatelessUnit<BoxDecoder<N>, rtl::DecodeJob<N>, rtl::DecodeResult> {
  static constexpr std::string_view kName = "box_decoder";
  static constexpr std::string_view kSummary = "a stored child and its parent's context to floats and its own context";
  static constexpr std::string_view kLatencyText = "3";
  static constexpr std::uint32_t kLatency = 3;
  static constexpr const auto& kClasses = kDecodeJobClasses;

  static rtl::DecodeJob<N> generate_one(std::size_t case_class, Random& random, const Parameters&) {
    return to_wires<N>(make_decode_job(case_class, random, N));
  }

  static rtl::DecodeResult respond_one(const rtl::DecodeJob<N>& job, const Parameters&) {
    std::array<DecodedAxis, 3> axes;
    rtl::Status status = rtl::Status::ok;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      axes[axis] = decode_axis(
          {static_cast<std::uint8_t>(job.node.lo[axis].raw()), static_cast<std::uint8_t>(job.node.hi[axis].raw())},
          from_wires(job.parent[axis]), job.registers, N);
      const rtl::Status found = axes[axis].status;
      if (found != rtl::Status::ok && (status == rtl::Status::ok || found < status)) status = found;
    }
    rtl::DecodeResult result;
    result.status = rtl::StatusBits(static_cast<std::uint64_t>(status));
    if (status != rtl::Status::ok) return result;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const int scale = static_cast<int>(job.parent[axis].scale.value());
      result.box.lower[axis] = rtl::Float32::of(decoded_edge(axes[axis].cells.lower, scale));
      result.box.upper[axis] = rtl::Float32::of(decoded_edge(axes[axis].cells.upper, scale));
      result.context[axis] = to_wires(axes[axis].own);
    }
    result.leaf = job.node.leaf;
    result.pointer = job.node.pointer;
    return result;
  }
};

}  // namespace cbvh::vectors
