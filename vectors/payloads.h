// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_model/datapath/payloads.h"

/// Stimuli and responses of the units that talk to memory: what happens at their ports, told in an order that no stall
/// can change.
namespace cbvh::vectors {

/// A step of an episode of the backtrack unit.
template <int N>
struct BacktrackStep {
  rtl::UInt<1> repair;  ///< 0: memory holds `pair` at `index`; 1: do `job`
  rtl::Pointer index;
  rtl::NodePair<N> pair;
  rtl::RepairJob job;
  static constexpr auto fields() {
    return rtl::field_list("repair", &BacktrackStep::repair, "index", &BacktrackStep::index, "pair",
                           &BacktrackStep::pair, "job", &BacktrackStep::job);
  }
  bool operator==(const BacktrackStep&) const = default;
};

/// What the backtrack unit does: pairs written in order, then the end of the job with the number of them.
template <int N>
struct BacktrackEvent {
  rtl::UInt<1> done;
  rtl::Pointer index;
  rtl::NodePair<N> pair;
  rtl::UInt<32> repairs;
  static constexpr auto fields() {
    return rtl::field_list("done", &BacktrackEvent::done, "index", &BacktrackEvent::index, "pair",
                           &BacktrackEvent::pair, "repairs", &BacktrackEvent::repairs);
  }
  bool operator==(const BacktrackEvent&) const = default;
};

/// What the stream compressor did to memory: its repairs in order, then memory as it is at the end, pair by pair, then
/// the report.
template <int N>
struct StreamEvent {
  enum class Kind : std::uint8_t { repair, memory, report };
  rtl::UInt<2> kind;
  rtl::Pointer index;
  rtl::NodePair<N> pair;
  rtl::StreamReport report;
  static constexpr auto fields() {
    return rtl::field_list("kind", &StreamEvent::kind, "index", &StreamEvent::index, "pair", &StreamEvent::pair,
                           "report", &StreamEvent::report);
  }
  bool operator==(const StreamEvent&) const = default;
};

}  // namespace cbvh::vectors
