// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "tests/faults/faulty_bits.h"

#include <algorithm>
#include <stdexcept>

namespace cbvh::testing {

namespace {

template <class Enumeration, class Names>
Enumeration find_name(const Names& names, const std::string& name, const std::string& text) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) throw std::invalid_argument("fault '" + text + "': unknown name '" + name + "'");
  return static_cast<Enumeration>(found - names.begin());
}

}  // namespace

std::string Fault::name() const {
  switch (kind) {
    case Kind::none:
      return "none";
    case Kind::decision:
      return "decision:" + std::string(rtl::kCornerNames[static_cast<std::size_t>(corner)]);
    case Kind::operator_result:
      break;
  }
  return std::string(rtl::kDatapathNames[static_cast<std::size_t>(datapath)]) + ":" + std::to_string(site) + ":" +
         std::to_string(bit);
}

Fault Fault::parse(const std::string& text) {
  Fault fault;
  if (text == "none") return fault;
  const auto first = text.find(':');
  if (first == std::string::npos)
    throw std::invalid_argument("fault '" + text + "': want DATAPATH:SITE:BIT or decision:NAME");
  const std::string head = text.substr(0, first);
  if (head == "decision") {
    fault.kind = Kind::decision;
    fault.corner = find_name<rtl::Corner>(rtl::kCornerNames, text.substr(first + 1), text);
    return fault;
  }
  fault.kind = Kind::operator_result;
  fault.datapath = find_name<rtl::Datapath>(rtl::kDatapathNames, head, text);
  const auto second = text.find(':', first + 1);
  if (second == std::string::npos) throw std::invalid_argument("fault '" + text + "': want DATAPATH:SITE:BIT");
  fault.site = static_cast<std::uint32_t>(std::stoul(text.substr(first + 1)));
  fault.bit = static_cast<std::uint32_t>(std::stoul(text.substr(second + 1)));
  return fault;
}

std::vector<rtl::Corner> control_decisions() {
  using rtl::Corner;
  return {Corner::stack_overflow,        Corner::stack_underflow,        Corner::collector_queue_full,
          Corner::stream_stops_on_error, Corner::backtrack_recurses,     Corner::backtrack_both_children,
          Corner::backtrack_stops,       Corner::combiner_merges,        Corner::combiner_flushes_for_read,
          Corner::child_scale_changed,   Corner::child_lower_changed,    Corner::sorter_next_run,
          Corner::emitter_joins_leaf,    Corner::emitter_closes_several, Corner::merger_waits,
          Corner::merger_half_line,      Corner::merger_rewrites,        Corner::writer_evicts,
          Corner::writer_completes,      Corner::writer_forwards,        Corner::gatherer_misses,
          Corner::top_down_parks,        Corner::ray_drops_waiting,      Corner::ray_leaf_crosses_lines,
          Corner::ray_stack_overflow};
}

}  // namespace cbvh::testing
