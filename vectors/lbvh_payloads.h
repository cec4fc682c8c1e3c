// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_model/datapath/lbvh_payloads.h"

/// Stimuli and responses of the units of the LBVH builder, where they are not those of a channel: configuration, and
/// what happens at a port to memory, told in an order that no stall can change.
namespace cbvh::vectors {

/// A line that the primitive reader finds in memory.
struct PrimitiveLine {
  rtl::LineAddress first_line;                  ///< configuration, the same in all lines of an episode
  rtl::UInt<rtl::kPointerBits + 1> primitives;  ///< likewise
  rtl::LineWords words;
  static constexpr auto fields() {
    return rtl::field_list("first_line", &PrimitiveLine::first_line, "primitives", &PrimitiveLine::primitives, "words",
                           &PrimitiveLine::words);
  }
  bool operator==(const PrimitiveLine&) const = default;
};

/// A box for the Morton encoder.
struct MortonJob {
  rtl::PrimitiveBox box;
  rtl::SceneBox registers;  ///< configuration, the same in all jobs of an episode
  static constexpr auto fields() { return rtl::field_list("box", &MortonJob::box, "registers", &MortonJob::registers); }
  bool operator==(const MortonJob&) const = default;
};

/// A record for the run writer.
struct RunStep {
  rtl::SortItem item;
  rtl::RunArea area;  ///< of the pass, the same in all its records
  static constexpr auto fields() { return rtl::field_list("item", &RunStep::item, "area", &RunStep::area); }
  bool operator==(const RunStep&) const = default;
};

/// What the run writer sends: a line to memory, or a run to its readers.
struct RunEvent {
  rtl::UInt<1> is_run;
  rtl::LineRequest request;
  rtl::RunDescriptor run;
  static constexpr auto fields() {
    return rtl::field_list("is_run", &RunEvent::is_run, "request", &RunEvent::request, "run", &RunEvent::run);
  }
  bool operator==(const RunEvent&) const = default;
};

/// What the run merger sends: a record of a pass that goes back to memory, or of the scene in order.
struct MergeEvent {
  rtl::UInt<1> rewritten;
  rtl::SortItem item;
  static constexpr auto fields() {
    return rtl::field_list("rewritten", &MergeEvent::rewritten, "item", &MergeEvent::item);
  }
  bool operator==(const MergeEvent&) const = default;
};

/// A record for the hierarchy emitter.
struct EmitStep {
  rtl::SortItem item;
  rtl::SceneRegisters registers;  ///< configuration, the same in all records of an episode
  static constexpr auto fields() { return rtl::field_list("item", &EmitStep::item, "registers", &EmitStep::registers); }
  bool operator==(const EmitStep&) const = default;
};

/// What the hierarchy emitter sends: of each scene its pairs, then its IDs, then the report.
struct EmitEvent {
  enum class Kind : std::uint8_t { pair, id, report };
  rtl::UInt<2> kind;
  rtl::StreamJob job;
  rtl::IdEntry id;
  rtl::EmitReport report;
  static constexpr auto fields() {
    return rtl::field_list("kind", &EmitEvent::kind, "job", &EmitEvent::job, "id", &EmitEvent::id, "report",
                           &EmitEvent::report);
  }
  bool operator==(const EmitEvent&) const = default;
};

/// An entry for the ID writer.
struct IdStep {
  rtl::IdEntry entry;
  rtl::LineAddress base;  ///< configuration, the same in all entries of an episode
  static constexpr auto fields() { return rtl::field_list("entry", &IdStep::entry, "base", &IdStep::base); }
  bool operator==(const IdStep&) const = default;
};

/// What a unit that writes a stream sends: a line to memory, or the report.
struct WriteEvent {
  rtl::UInt<1> is_report;
  rtl::LineRequest request;
  rtl::WriteReport report;
  static constexpr auto fields() {
    return rtl::field_list("is_report", &WriteEvent::is_report, "request", &WriteEvent::request, "report",
                           &WriteEvent::report);
  }
  bool operator==(const WriteEvent&) const = default;
};

}  // namespace cbvh::vectors
