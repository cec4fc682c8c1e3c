// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "rtl_model/compress/backtrack_unit.h"

#include "rtl_model/bits/machine_bits.h"
#include "testbench/lockstep/in_out.h"
#include "testbench/rtl/memory_port.h"
#include "vectors/payloads.h"

namespace cbvh::testbench {

namespace {

/// Puts into memory, before each clock, what it must hold for the next job once the one before is done.
template <int N>
class Filler {
 public:
  Filler(std::span<const vectors::BacktrackStep<N>> steps, rtl::FixedLatencyMemory<N>& memory,
         const rtl::Channel<rtl::UInt<32>>& done)
      : steps_(steps), memory_(memory), done_(done) {
    fill();
  }
  void commit(rtl::CommitKey) { fill(); }

 private:
  void fill() {
    for (; next_ < steps_.size() && jobs_passed_ <= done_.pushes(); ++next_) {
      const auto& step = steps_[next_];
      if (step.repair) {
        ++jobs_passed_;
        continue;
      }
      const std::size_t index = step.index.value();
      if (memory_.pairs.size() <= index) memory_.pairs.resize(index + 1);
      memory_.pairs[index] = step.pair;
    }
  }

  std::span<const vectors::BacktrackStep<N>> steps_;
  rtl::FixedLatencyMemory<N>& memory_;
  const rtl::Channel<rtl::UInt<32>>& done_;
  std::size_t next_ = 0;
  std::uint64_t jobs_passed_ = 0;
};

template <int N>
Episode record(std::span<const vectors::BacktrackStep<N>> steps, const RunOptions& options, std::uint64_t number) {
  std::vector<rtl::RepairJob> items;
  for (const auto& step : steps) {
    if (step.repair) items.push_back(step.job);
  }
  rtl::Channel<rtl::RepairJob> jobs;
  rtl::Channel<rtl::MemoryRequest<N>> requests;
  rtl::Channel<rtl::MemoryLine<N>> lines;
  rtl::Channel<rtl::UInt<32>> done;
  rtl::BacktrackUnit<rtl::MachineBits, N> unit(jobs, requests, lines, done);
  auto memory = make_memory(requests, lines, options, number);
  Source<rtl::RepairJob> source(jobs, items, source_stalls(options, number));
  Sink<rtl::UInt<32>> sink(done, sink_stalls(options, number));
  Probe<rtl::RepairJob> job_probe(jobs, "jobs", Flow::to_unit);
  Probe<rtl::MemoryRequest<N>> request_probe(requests, "requests", Flow::from_unit);
  Probe<rtl::MemoryLine<N>> line_probe(lines, "lines", Flow::to_unit);
  Probe<rtl::UInt<32>> done_probe(done, "done", Flow::from_unit);
  Filler<N> filler(steps, memory, done);
  rtl::Clock clock(source, jobs, unit, requests, memory, lines, done, sink, filler, job_probe, request_probe,
                   line_probe, done_probe);
  return record_episode(clock, job_probe, request_probe, line_probe, done_probe);
}

}  // namespace

/// With memory as in the regression: reads come late when sinks stall.
LockstepTwin backtrack_unit_twin() {
  return {"backtrack_unit", kLockstepBits, verilog_bits,
          [](const vectors::Parameters& parameters, const RunOptions& options, std::uint64_t seed) {
            return with_lockstep_bits(parameters.bits, [&]<int N>(std::integral_constant<int, N>) {
              const auto set = vectors::generate_set("backtrack_unit", parameters, 48, seed);
              const auto steps = typed_stimuli<vectors::BacktrackStep<N>, vectors::BacktrackEvent<N>>(
                  *set, {0, set->stimulus_count()});
              return std::vector<Episode>{record<N>(steps, options, seed)};
            });
          }};
}

}  // namespace cbvh::testbench
