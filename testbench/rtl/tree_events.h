// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_model/datapath/node_words.h"
#include "testbench/rtl/in_out_bench.h"
#include "testbench/rtl/line_channels.h"
#include "testbench/rtl/line_memory.h"

namespace cbvh::testbench {

/// Runs units that leave a packed tree in memory: one command, one report, each case through a unit of its own.
/// run(steps, number, store, report) does it and says whether it finished; `first_line` is where the tree lies.
template <int N, class Command, class Report, class Run>
Responses run_trees(const vectors::VectorSet& set, std::uint64_t first_line, Run&& run) {
  using Event = vectors::TreeEvent<N, Report>;
  Responses responses(sizeof(Event));
  for (std::size_t index = 0; index < set.size(); ++index) {
    const auto steps = typed_stimuli<vectors::MemoryStep<Command>, Event>(set, set.stimulus_range(index));
    const bool finished = run(
        steps, set.head(index).id, responses,
        [&](const rtl::LineStore& store, std::uint64_t pairs, const Report& report, bool refused) {
          for (std::uint64_t i = 0; i < pairs && !refused; ++i) {
            rtl::PairWords words;
            for (std::size_t word = 0; word < words.size(); ++word) {
              words[word] = rtl::UInt<32>(store.peek(first_line * rtl::kWordsPerLine + i * rtl::kWordsPerPair + word));
            }
            const Event event{rtl::UInt<1>(0), rtl::Pointer(i), rtl::unpack_pair<N>(words), {}};
            responses.add(&event, vectors::kLatencyNotStated);
          }
          const Event event{rtl::UInt<1>(1), {}, {}, report};
          responses.add(&event, vectors::kLatencyNotStated);
        });
    responses.end_case(!finished);
  }
  return responses;
}

}  // namespace cbvh::testbench
