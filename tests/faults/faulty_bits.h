// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "rtl_model/bits/machine_bits.h"

/// A bit type for a test build of the model: exactly one of its operators gives a wrong result, or exactly one of its
/// decisions is taken the wrong way, wherever and whenever it is used. It shows whether a regression notices.
namespace cbvh::testing {

/// One deliberate fault.
struct Fault {
  enum class Kind : std::uint8_t { none, operator_result, decision };
  Kind kind = Kind::none;
  rtl::Datapath datapath{};  ///< operator_result: whose
  std::uint32_t site = 0;    ///< operator_result: which operator of it, counted in order of evaluation
  std::uint32_t bit = 0;     ///< operator_result: which bit of the result is inverted; at most the highest
  rtl::Corner corner{};      ///< decision: which one is inverted

  /// "compress_axis:17:3" or "decision:combiner_merges".
  std::string name() const;
  /// The inverse of name(); throws std::invalid_argument.
  static Fault parse(const std::string& text);
};

/// The fault in force, for all threads. Set it while nothing runs.
inline Fault active_fault;

/// Which operator of which datapath this thread is evaluating.
struct Evaluation {
  rtl::Datapath datapath = rtl::Datapath::count;  ///< count: none
  std::uint32_t site = 0;
};
inline constinit thread_local Evaluation evaluation;

/// The most operators seen in one evaluation of each datapath, by this thread.
inline constinit thread_local std::array<std::uint32_t, rtl::kDatapaths> operators_seen{};

struct FaultyHook {
  template <int W>
  static std::uint64_t result(std::uint64_t raw) {
    if (evaluation.datapath == rtl::Datapath::count) return raw;
    const std::uint32_t site = evaluation.site++;
    if (active_fault.kind != Fault::Kind::operator_result || active_fault.datapath != evaluation.datapath ||
        active_fault.site != site) {
      return raw;
    }
    return raw ^ (std::uint64_t{1} << std::min<std::uint32_t>(active_fault.bit, W - 1));
  }
};

struct FaultyBits {
  using Hook = FaultyHook;
  template <int W>
  using U = rtl::UInt<W, Hook>;
  template <int W>
  using S = rtl::SInt<W, Hook>;
  using F = U<32>;

  /// Numbers the operators of a datapath from zero, and those of the one around it on from where they were.
  class Scope {
   public:
    explicit Scope(rtl::Datapath datapath) : outer_(evaluation) { evaluation = {datapath, 0}; }
    ~Scope() {
      auto& seen = operators_seen[static_cast<std::size_t>(evaluation.datapath)];
      if (evaluation.site > seen) seen = evaluation.site;
      evaluation = outer_;
    }
    Scope(const Scope&) = delete;
    Scope& operator=(const Scope&) = delete;

   private:
    Evaluation outer_;
  };

  static U<1> corner(rtl::Corner corner, U<1> taken) {
    const bool inverted = active_fault.kind == Fault::Kind::decision && active_fault.corner == corner;
    return U<1>::of_raw(taken.raw() ^ inverted);
  }
};

/// The decisions whose answer steers control logic: those that a wrong answer changes.
std::vector<rtl::Corner> control_decisions();

}  // namespace cbvh::testing
