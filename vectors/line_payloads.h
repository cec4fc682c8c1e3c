// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_model/datapath/refit_payloads.h"

/// Stimuli and responses of the units with ports to memory by lines: what happens at their ports, told in an order that
/// no stall can change.
namespace cbvh::vectors {

/// A step of an episode of a unit that reads arrays: memory, as all steps together leave it, then commands in order.
template <class Command>
struct MemoryStep {
  rtl::UInt<1> act;  ///< 0: memory holds `words` at `line`; 1: the unit gets `command`
  rtl::LineAddress line;
  rtl::LineWords words;
  Command command;
  static constexpr auto fields() {
    return rtl::field_list("act", &MemoryStep::act, "line", &MemoryStep::line, "words", &MemoryStep::words, "command",
                           &MemoryStep::command);
  }
  bool operator==(const MemoryStep&) const = default;
};

/// What the node writer gets.
template <int N>
struct NodeWriterStep {
  rtl::UInt<1> ends;  ///< 0: `request`; 1: `report`, which ends a tree
  rtl::MemoryRequest<N> request;
  rtl::StreamReport report;
  static constexpr auto fields() {
    return rtl::field_list("ends", &NodeWriterStep::ends, "request", &NodeWriterStep::request, "report",
                           &NodeWriterStep::report);
  }
  bool operator==(const NodeWriterStep&) const = default;
};

/// What the node writer did: the pairs that reads wanted, then its accesses in order, then the reports it passed on.
template <int N>
struct NodeWriterEvent {
  enum class Kind : std::uint8_t { answer, access, report };
  rtl::UInt<2> kind;
  rtl::NodePair<N> pair;
  rtl::LineRequest access;
  rtl::StreamReport report;
  static constexpr auto fields() {
    return rtl::field_list("kind", &NodeWriterEvent::kind, "pair", &NodeWriterEvent::pair, "access",
                           &NodeWriterEvent::access, "report", &NodeWriterEvent::report);
  }
  bool operator==(const NodeWriterEvent&) const = default;
};

/// What the gatherer gets: for each array its place and then IDs.
struct GatherInput {
  rtl::UInt<1> is_id;
  rtl::ReadCommand array;
  rtl::IdEntry id;
  static constexpr auto fields() {
    return rtl::field_list("is_id", &GatherInput::is_id, "array", &GatherInput::array, "id", &GatherInput::id);
  }
  bool operator==(const GatherInput&) const = default;
};

/// What the gatherer gave: primitives with their marks, then the lines it read, in order.
struct GatherEvent {
  rtl::UInt<1> access;
  rtl::Primitive primitive;
  rtl::LeafMark mark;
  rtl::LineAddress line;
  static constexpr auto fields() {
    return rtl::field_list("access", &GatherEvent::access, "primitive", &GatherEvent::primitive, "mark",
                           &GatherEvent::mark, "line", &GatherEvent::line);
  }
  bool operator==(const GatherEvent&) const = default;
};

/// What the walker gets; the order counts within a kind.
struct WalkStep {
  enum class Kind : std::uint8_t { start, pair, primitive };
  rtl::UInt<2> kind;
  rtl::SceneRegisters registers;
  rtl::TopologyPair pair;
  rtl::PrimitiveBox primitive;
  rtl::LeafMark mark;
  static constexpr auto fields() {
    return rtl::field_list("kind", &WalkStep::kind, "registers", &WalkStep::registers, "pair", &WalkStep::pair,
                           "primitive", &WalkStep::primitive, "mark", &WalkStep::mark);
  }
  bool operator==(const WalkStep&) const = default;
};

/// What the walker gave: the jobs of a tree, then its report.
struct WalkEvent {
  rtl::UInt<1> ends;
  rtl::StreamJob job;
  rtl::WalkReport report;
  static constexpr auto fields() {
    return rtl::field_list("ends", &WalkEvent::ends, "job", &WalkEvent::job, "report", &WalkEvent::report);
  }
  bool operator==(const WalkEvent&) const = default;
};

/// A tree as a unit left it in memory: its pairs in index order, unless it was refused, then the report.
template <int N, class Report>
struct TreeEvent {
  rtl::UInt<1> ends;
  rtl::Pointer index;
  rtl::NodePair<N> pair;
  Report report;
  static constexpr auto fields() {
    return rtl::field_list("ends", &TreeEvent::ends, "index", &TreeEvent::index, "pair", &TreeEvent::pair, "report",
                           &TreeEvent::report);
  }
  bool operator==(const TreeEvent&) const = default;
};

}  // namespace cbvh::vectors
