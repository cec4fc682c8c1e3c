// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tuple>
#include <vector>

#include "rtl_model/compress/stream_compressor.h"
#include "rtl_model/lbvh/pipeline_config.h"
#include "rtl_model/memory/node_writer.h"

namespace cbvh::rtl {

/// The LBVH pipeline's output for streaming compression: pairs leave compressed, and what turns out to be wrong is
/// repaired in memory by a sequential backtrack unit. Paper table 2, last two columns.
template <class Bits, int N, template <class, int> class Collector>
class StreamingOutput {
 public:
  static constexpr const char* kFirstModule = "treelet_collector";

  StreamingOutput(Channel<StreamJob>& jobs, const LbvhConfig& config)
      : compressor_(jobs, pair_requests_, pair_lines_, reports_, config.treelet),
        writer_(pair_requests_, pair_lines_, reports_, link_.port(), finished_, {config.pairs, config.held_lines}) {}

  auto parts() { return std::tie(compressor_, pair_requests_, pair_lines_, reports_, writer_, link_, finished_); }
  template <class Visit>
  void channels(Visit&& visit) const {
    compressor_.channels(visit);
    visit("pair_requests", "line_combiner", "node_writer", pair_requests_);
    visit("pair_lines", "node_writer", "backtrack_unit", pair_lines_);
    visit("reports", "line_combiner", "node_writer", reports_);
    link_.channels("node_writer", visit);
  }
  std::vector<NamedPort> ports() { return {{"node_writer", link_.port()}}; }
  bool done() const { return finished_.can_pop(); }
  const StreamReport& report() const { return finished_.front(); }
  const NodeWriter<Bits, N>& writer() const { return writer_; }

 private:
  LineLink link_;
  Channel<MemoryRequest<N>> pair_requests_;
  Channel<MemoryLine<N>> pair_lines_;
  Channel<StreamReport> reports_;
  Channel<StreamReport> finished_;
  StreamCompressor<Bits, N, Collector> compressor_;
  NodeWriter<Bits, N> writer_;
};

}  // namespace cbvh::rtl
