// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "rtl_model/compress/node_pair_compressor.h"

#include <gtest/gtest.h>

#include "golden/build/lbvh.h"
#include "golden/quantize/quantize.h"
#include "golden/scene/trouble_scenes.h"
#include "rtl_model/compress/serial_node_pair_compressor.h"
#include "tests/support/unit_run.h"
#include "vectors/convert.h"

namespace cbvh::rtl {
namespace {

using testing::Disturbance;

/// Pairs of small troublesome scenes, some with their estimate and some with a given, coarser context.
std::vector<PairJob> pair_jobs() {
  std::vector<PairJob> jobs;
  for (const auto trouble : golden::kTroubles) {
    for (std::uint64_t seed = 0; seed < 4; ++seed) {
      const auto tree = golden::build_lbvh(golden::trouble_scene(trouble, seed));
      golden::GridRules rules{6, golden::exactness_limit(tree.largest_magnitude)};
      const auto code = seed % 2 == 0 ? golden::Code::modulo : golden::Code::relative;
      const auto registers = vectors::scene_registers(rules, code);
      for (const auto& pair : tree.pairs) {
        PairJob job{vectors::float_pair(pair), UInt<1>(0), {}, registers};
        jobs.push_back(job);
        job.given_context = UInt<1>(1);
        job.context = vectors::context(golden::root_context<std::int64_t>(tree.scene, rules));
        jobs.push_back(job);
      }
    }
  }
  return jobs;
}

template <class Unit>
testing::Observed<PairResult<6>> run(const std::vector<PairJob>& jobs, const Disturbance& disturbance) {
  return testing::run_unit<PairJob, PairResult<6>>(jobs, disturbance,
                                                   [](auto& in, auto& out) { return std::make_unique<Unit>(in, out); });
}

TEST(NodePairCompressor, serial_variant_gives_the_same_results_with_latency_14_instead_of_6) {
  const auto jobs = pair_jobs();
  ASSERT_GT(jobs.size(), 1000u);
  const auto parallel = run<NodePairCompressor<MachineBits, 6>>(jobs, {});
  const auto serial = run<SerialNodePairCompressor<MachineBits, 6>>(jobs, {});
  ASSERT_EQ(parallel.responses.size(), jobs.size());
  EXPECT_EQ(serial.responses, parallel.responses);
  for (const auto latency : parallel.latencies()) ASSERT_EQ(latency, 6u);
  for (const auto latency : serial.latencies()) ASSERT_EQ(latency, 14u);
}

TEST(NodePairCompressor, result_is_unchanged_when_source_and_sink_stall_in_any_order_of_evaluation) {
  const auto jobs = pair_jobs();
  const auto quiet = run<NodePairCompressor<MachineBits, 6>>(jobs, {});
  for (const auto& disturbance : testing::stall_matrix()) {
    EXPECT_EQ((run<NodePairCompressor<MachineBits, 6>>(jobs, disturbance).responses), quiet.responses);
    EXPECT_EQ((run<SerialNodePairCompressor<MachineBits, 6>>(jobs, disturbance).responses), quiet.responses);
  }
}

TEST(NodePairCompressor, one_refused_axis_refuses_the_pair_with_the_lowest_reason) {
  auto job = pair_jobs().front();
  job.pair.box[1].upper[2] = Float32::of_raw(0x7FC00000);
  job.pair.box[0].lower[0] = Float32::of(2);
  job.pair.box[0].upper[0] = Float32::of(1);
  PairResult<6> want;
  want.status = StatusBits(static_cast<std::uint64_t>(Status::not_finite));
  EXPECT_EQ((compress_pair<MachineBits, 6>(job)), want);
}

}  // namespace
}  // namespace cbvh::rtl
