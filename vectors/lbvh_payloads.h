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

}  // namespace cbvh::vectors
