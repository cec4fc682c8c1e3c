// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "vectors/faces/backtrack.h"
#include "vectors/faces/timing.h"
#include "vectors/units/treelet_collector.h"

namespace cbvh::vectors {

/// Float pairs in emission order become a compressed tree in memory. For each tree: its repairs in order, memory pair
/// by pair in index order, the report. A refused tree has only the report.
template <int N>
struct StreamCompressor {
  using Stimulus = rtl::StreamJob;
  using Response = StreamEvent<N>;
  using Kind = typename Response::Kind;
  static constexpr std::string_view kName = "stream_compressor";
  static constexpr std::string_view kSummary = "float pairs in emission order to a compressed tree in memory";
  static constexpr std::string_view kLatencyText = "6 D + 3, if no repairs";
  static constexpr bool kStateful = true;
  static constexpr bool kTreelet = true;
  static constexpr const auto& kClasses = kStreamClasses;

  static std::vector<Stimulus> generate(std::size_t case_class, Random& random, const Parameters&) {
    return make_stream(case_class, random);
  }

  static std::vector<Expected<Response>> respond(std::span<const Stimulus> jobs, const Parameters& parameters) {
    std::vector<Expected<Response>> events;
    std::size_t tree_begin = 0;
    BacktrackMemory memory(N);
    const auto answers = collect(jobs, parameters.treelet, N);
    // Stated for the first tree only, and only if it repairs nothing: else it depends on how memory accesses
    // interleave.
    const auto cycles = collector_cycles(jobs, answers, {parameters.treelet, false}, N);
    bool stated = true;
    for (std::size_t i = 0; i < answers.size(); ++i) {
      const FinalAnswer& answer = answers[i];
      stated = stated && !answer.repair[0] && !answer.repair[1];
      const std::uint32_t latency = stated ? cycles[i] + kReportCycles : kLatencyNotStated;
      stated = stated && !answer.last;
      if (answer.status != rtl::Status::ok) {
        events.resize(tree_begin);  // its repairs are not told
        events.push_back(report(answer, answer.index, 0, latency));
      } else {
        memory.write(answer.index, answer.pair);
        repair_children(answer, memory, events);
        if (answer.last) {
          const std::uint64_t repairs = events.size() - tree_begin;
          for (const auto& [index, pair] : memory.pairs()) events.push_back(event(Kind::memory, index, pair));
          events.push_back(report(answer, memory.pairs().rbegin()->first, repairs, latency));
        }
      }
      if (answer.last) {
        memory.clear();
        tree_begin = events.size();
      }
    }
    return events;
  }

 private:
  static Expected<Response> event(Kind kind, std::uint32_t index, const golden::CompressedPair& pair) {
    return {{rtl::UInt<2>(static_cast<std::uint64_t>(kind)), rtl::Pointer(index), to_wires<N>(pair), {}},
            kLatencyNotStated};
  }

  static void repair_children(const FinalAnswer& answer, BacktrackMemory& memory,
                              std::vector<Expected<Response>>& events) {
    for (std::size_t c = 0; c < 2; ++c) {
      if (!answer.repair[c]) continue;
      const std::uint32_t child = answer.pair.child[c].pointer;
      for (const RepairedPair& pair : memory.repair(child, answer.before[c], answer.after[c], answer.registers)) {
        events.push_back(event(Kind::repair, pair.index, pair.pair));
      }
    }
  }

  static Expected<Response> report(const FinalAnswer& answer, std::uint32_t last_index, std::uint64_t repairs,
                                   std::uint32_t latency) {
    Response response;
    response.kind = rtl::UInt<2>(static_cast<std::uint64_t>(Kind::report));
    response.report = {rtl::Pointer(last_index), rtl::UInt<32>(repairs), to_wires(answer.root),
                       rtl::StatusBits(static_cast<std::uint64_t>(answer.status))};
    return {response, latency};
  }
};

}  // namespace cbvh::vectors
