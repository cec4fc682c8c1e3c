// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// The C++ module of the axis compressor against the golden, case by case, generated in process: what a regression of an
// own implementation would cost on one core.
#include <benchmark/benchmark.h>

#include <array>

#include "rtl_model/compress/axis_compressor.h"
#include "rtl_model/kernel/clock.h"
#include "rtl_model/kernel/random.h"
#include "vectors/units/axis_compressor.h"

namespace cbvh {
namespace {

constexpr int kBits = 6;
using Result = rtl::AxisResult<kBits>;

/// Intervals of 0 to 32 cells anywhere in +-2^20, on a grid of 2^-4 .. 2^3.
class Intervals {
 public:
  rtl::AxisJob next() {
    const std::uint64_t random = random_.next();
    const float lower = static_cast<float>(static_cast<std::int32_t>(random >> 43)) * 1.0009765625F - 1048576.0F;
    const int scale = static_cast<int>(random & 7) - 4;
    const float cell = static_cast<float>(1 << (random & 7)) * 0.0625F;
    const float size = static_cast<float>(random >> 8 & 0xFFFF) * (32.0F / 65536.0F) * cell;
    return {rtl::Float32::of(lower), rtl::Float32::of(lower + size), rtl::Scale(scale), registers_};
  }

 private:
  rtl::SplitMix64 random_{1};
  rtl::SceneRegisters registers_{rtl::Scale(-4), {}, {}};
};

void generate(benchmark::State& state) {
  Intervals intervals;
  for (auto _ : state) benchmark::DoNotOptimize(intervals.next());
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(generate);

void golden_alone(benchmark::State& state) {
  Intervals intervals;
  for (auto _ : state) benchmark::DoNotOptimize(vectors::AxisCompressor<kBits>::respond_one(intervals.next(), {}));
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(golden_alone);

void module_alone(benchmark::State& state) {
  Intervals intervals;
  rtl::Channel<rtl::AxisJob> jobs;
  rtl::Channel<Result> results;
  rtl::AxisCompressor<rtl::MachineBits, kBits> unit(jobs, results);
  rtl::Clock clock(unit, jobs, results);
  for (auto _ : state) {
    jobs.push(intervals.next());
    if (results.can_pop()) benchmark::DoNotOptimize(results.pop());
    clock.step();
  }
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(module_alone);

/// One case a clock: generated, sent through the module, and compared with what the golden says, all fields.
void module_against_golden(benchmark::State& state) {
  Intervals intervals;
  rtl::Channel<rtl::AxisJob> jobs;
  rtl::Channel<Result> results;
  rtl::AxisCompressor<rtl::MachineBits, kBits> unit(jobs, results);
  rtl::Clock clock(unit, jobs, results);
  std::array<Result, 8> expected;  // of the jobs on their way
  std::uint64_t sent = 0;
  std::uint64_t checked = 0;
  for (auto _ : state) {
    const rtl::AxisJob job = intervals.next();
    expected[sent++ % expected.size()] = vectors::AxisCompressor<kBits>::respond_one(job, {});
    jobs.push(job);
    if (results.can_pop() && !(results.pop() == expected[checked++ % expected.size()])) {
      state.SkipWithError("the module and the golden differ");
      break;
    }
    clock.step();
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(checked));
}
BENCHMARK(module_against_golden);

}  // namespace
}  // namespace cbvh

BENCHMARK_MAIN();
