// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/rtl/in_out_bench.h"
#include "testbench/rtl/stream_run.h"
#include "vectors/payloads.h"

namespace cbvh::testbench {

namespace {

/// Turns what went through the memory port into events: of each tree the repairs, then memory as it is, then the
/// report. Of a refused tree only the report: what it left in memory is void.
template <int N>
class EventWriter {
 public:
  using Event = vectors::StreamEvent<N>;

  EventWriter(const StreamTrace<N>& trace, Responses& responses) : trace_(trace), responses_(responses) {}

  void add_tree(const typename StreamTrace<N>::Report& end) {
    std::vector<rtl::NodePair<N>> memory;
    std::vector<bool> written;
    const bool ok = end.report.status == rtl::StatusBits();
    for (; next_ < trace_.writes.size() && trace_.writes[next_].cycle <= end.sent + 1; ++next_) {
      const auto& [cycle, request] = trace_.writes[next_];
      for (std::size_t slot = 0; slot < rtl::kPairsPerLine; ++slot) {
        if ((request.mask.value() >> slot & 1U) == 0) continue;
        const std::size_t index = request.line.value() * rtl::kPairsPerLine + slot;
        if (memory.size() <= index) {
          memory.resize(index + 1);
          written.resize(index + 1);
        }
        memory[index] = request.pairs[slot];
        if (ok && written[index]) add({kind(Event::Kind::repair), rtl::Pointer(index), request.pairs[slot], {}}, cycle);
        written[index] = true;
      }
    }
    for (std::size_t index = 0; ok && index < memory.size(); ++index) {
      add({kind(Event::Kind::memory), rtl::Pointer(index), memory[index], {}}, end.seen);
    }
    add({kind(Event::Kind::report), {}, {}, end.report}, end.seen);
  }

 private:
  static rtl::UInt<2> kind(typename Event::Kind kind) { return rtl::UInt<2>(static_cast<std::uint64_t>(kind)); }
  void add(const Event& event, std::uint64_t cycle) { responses_.add(&event, to_latency(trace_.started, cycle)); }

  const StreamTrace<N>& trace_;
  Responses& responses_;
  std::size_t next_ = 0;
};

}  // namespace

UnitDriver stream_compressor_driver() {
  return {"stream_compressor", [](const vectors::VectorSet& set, const RunOptions& options) {
            return vectors::with_bits(set.parameters().bits, [&]<int N>(std::integral_constant<int, N>) {
              using Event = vectors::StreamEvent<N>;
              Responses responses(sizeof(Event));
              for (std::size_t index = 0; index < set.size(); ++index) {
                const auto jobs = typed_stimuli<rtl::StreamJob, Event>(set, set.stimulus_range(index));
                const auto trace =
                    run_stream<N>(Collector::full, set.parameters().treelet, jobs, options, set.head(index).id, true);
                EventWriter<N> events(trace, responses);
                for (const auto& report : trace.reports) events.add_tree(report);
                responses.end_case(trace.hung);
                responses.cycles += trace.cycles;
              }
              return responses;
            });
          }};
}

}  // namespace cbvh::testbench
