// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tuple>

#include "rtl_model/compress/backtrack_unit.h"
#include "rtl_model/compress/line_combiner.h"
#include "rtl_model/compress/treelet_collector.h"

namespace cbvh::rtl {

/// Float node pairs in emission order become final node pairs in memory, and repairs of earlier ones: the tree in
/// memory at the report equals the top-down compressed tree bit for bit. A pair a clock while nothing backtracks. Paper
/// figure 2b.
template <class Bits, int N, template <class, int> class Collector = TreeletCollector>
class StreamCompressor {
 public:
  /// `levels` is the treelet depth D, 1..8.
  StreamCompressor(Channel<StreamJob>& jobs, Channel<MemoryRequest<N>>& memory, Channel<MemoryLine<N>>& lines,
                   Channel<StreamReport>& reports, int levels)
      : collector_(jobs, finals_, levels),
        combiner_(finals_, repair_jobs_, repairs_done_, repair_requests_, memory, reports),
        backtrack_(repair_jobs_, repair_requests_, lines, repairs_done_) {}

  auto parts() {
    return std::tie(collector_, finals_, combiner_, repair_jobs_, repairs_done_, repair_requests_, backtrack_);
  }

  /// The channels between the parts (rtl_model/kernel/netlist.h).
  template <class Visit>
  void channels(Visit&& visit) const {
    visit("finals", "treelet_collector", "line_combiner", finals_);
    visit("repair_jobs", "line_combiner", "backtrack_unit", repair_jobs_);
    visit("repairs_done", "backtrack_unit", "line_combiner", repairs_done_);
    visit("repair_requests", "backtrack_unit", "line_combiner", repair_requests_);
  }

 private:
  Channel<FinalPair<N>> finals_;
  Channel<RepairJob> repair_jobs_;
  Channel<UInt<32>> repairs_done_;
  Channel<MemoryRequest<N>> repair_requests_;
  Collector<Bits, N> collector_;
  LineCombiner<Bits, N> combiner_;
  BacktrackUnit<Bits, N> backtrack_;
};

}  // namespace cbvh::rtl
