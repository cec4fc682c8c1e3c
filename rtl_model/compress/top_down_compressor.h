// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tuple>

#include "rtl_model/compress/node_pair_compressor.h"
#include "rtl_model/compress/top_down_scheduler.h"

namespace cbvh::rtl {

/// The paper's baseline: a float tree in memory, 64 bytes a pair, is read, compressed top-down, and written, 16 bytes a
/// pair. Optimistic as there: a memory access starts as soon as what it needs is known, and a pair as soon as its
/// context is. A pair a clock at most; 7 clocks from when a pair is sent to the compressor until a child of it can be.
/// Reports when all writes are acknowledged. Paper figure 2a, section 5.3 and table 2, TD.
template <class Bits, int N>
class TopDownCompressor {
 public:
  TopDownCompressor(Channel<TopDownCommand>& commands, LinePort reads, LinePort writes, Channel<StreamReport>& reports,
                    const TopDownAddresses& addresses)
      : scheduler_(commands, reads, writes, jobs_, results_, reports, addresses), compressor_(jobs_, results_) {}

  auto parts() { return std::tie(scheduler_, jobs_, compressor_, results_); }

  /// The channels between the parts (rtl_model/kernel/netlist.h).
  template <class Visit>
  void channels(Visit&& visit) const {
    visit("jobs", "top_down_scheduler", "node_pair_compressor", jobs_);
    visit("results", "node_pair_compressor", "top_down_scheduler", results_);
  }

 private:
  Channel<PairJob> jobs_;
  Channel<PairResult<N>> results_;
  TopDownScheduler<Bits, N> scheduler_;
  NodePairCompressor<Bits, N> compressor_;
};

}  // namespace cbvh::rtl
