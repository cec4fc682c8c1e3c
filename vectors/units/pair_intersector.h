// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "vectors/generate/pair_tests.h"
#include "vectors/ray_convert.h"
#include "vectors/unit.h"

namespace cbvh::vectors {

/// Both children of a stored pair against a ray that reached their parent. Codes are modulo or relative.
template <int N>
struct PairIntersector : StatelessUnit<PairIntersector<N>, rtl::PairTestJob<N>, rtl::PairTestResult<N>> {
  static constexpr std::string_view kName = "pair_intersector";
  static constexpr std::string_view kSummary = "both children of a stored pair against a ray that reached their parent";
  static constexpr std::string_view kLatencyText = "8";
  static constexpr std::uint32_t kLatency = 8;
  static constexpr const auto& kClasses = kPairTestClasses;

  static rtl::PairTestJob<N> generate_one(std::size_t case_class, Random& random, const Parameters&) {
    return to_wires<N>(make_pair_test(case_class, random, N));
  }

  static rtl::PairTestResult<N> respond_one(const rtl::PairTestJob<N>& job, const Parameters&) {
    const PairTestAnswer answer = test_pair(from_wires(job), N);
    rtl::PairTestResult<N> result;
    result.status = rtl::StatusBits(static_cast<std::uint64_t>(answer.status));
    if (answer.status != rtl::Status::ok) return result;
    for (std::size_t c = 0; c < 2; ++c) {
      const auto& [inside, node] = answer.child[c];
      result.child[c] = {rtl::UInt<1>(inside.hit), rtl::Float32::of(inside.entry), rtl::Float32::of(inside.exit),
                         to_wires<N>(node),        job.pair.child[c].leaf,         job.pair.child[c].pointer};
    }
    result.second_first = rtl::UInt<1>(answer.second_first);
    return result;
  }
};

}  // namespace cbvh::vectors
