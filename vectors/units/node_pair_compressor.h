// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "vectors/faces/pair.h"
#include "vectors/generate/pair_jobs.h"
#include "vectors/unit.h"

namespace cbvh::vectors {

/// Two siblings on the estimate of their union box or on a given context. Codes are modulo or relative.
template <class U, int N>
struct PairUnit : StatelessUnit<U, rtl::PairJob, rtl::PairResult<N>> {
  static constexpr const auto& kClasses = kPairJobClasses;

  static rtl::PairJob generate_one(std::size_t case_class, Random& random, const Parameters& parameters) {
    return make_pair_job(case_class, random, parameters.bits);
  }

  static rtl::PairResult<N> respond_one(const rtl::PairJob& job, const Parameters&) {
    std::optional<golden::Context<Index>> given;
    if (job.given_context) given = from_wires(job.context);
    const PairAnswer answer = compress_pair(job.pair, given, job.registers, N);
    rtl::PairResult<N> result;
    result.status = rtl::StatusBits(static_cast<std::uint64_t>(answer.status));
    if (answer.status != rtl::Status::ok) return result;
    result.pair = to_wires<N>(stored_pair(job.pair, answer, job.registers, N));
    result.context = to_wires(answer.context);
    for (std::size_t child = 0; child < 2; ++child) {
      result.child_context[child] = to_wires(answer.child_context[child]);
    }
    return result;
  }
};

/// Six axis compressors and three estimators.
template <int N>
struct NodePairCompressor : PairUnit<NodePairCompressor<N>, N> {
  static constexpr std::string_view kName = "node_pair_compressor";
  static constexpr std::string_view kSummary = "two sibling boxes to a node pair and the contexts of the children";
  static constexpr std::string_view kLatencyText = "6";
  static constexpr std::uint32_t kLatency = 6;
};

/// The same, with one axis compressor that is shared in time.
template <int N>
struct NodePairCompressorSerial : PairUnit<NodePairCompressorSerial<N>, N> {
  static constexpr std::string_view kName = "node_pair_compressor_serial";
  static constexpr std::string_view kSummary = "node_pair_compressor with one axis compressor, for small FPGAs";
  static constexpr std::string_view kLatencyText = "14";
  static constexpr std::uint32_t kLatency = 14;
};

}  // namespace cbvh::vectors
