// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "rtl_model/traverse/box_decoder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "golden/quantize/quantize.h"
#include "rtl_model/datapath/axis_compress.h"
#include "tests/support/unit_run.h"

namespace cbvh::rtl {
namespace {

using testing::Disturbance;

template <int N>
DecodeJob<N> axis_job(unsigned lo, unsigned hi, int scale, std::int64_t parent_lower, const SceneRegisters& registers) {
  DecodeJob<N> job;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    job.node.lo[axis] = UInt<N>(lo);
    job.node.hi[axis] = UInt<N>(hi);
    job.parent[axis] = {Scale(scale), CellIndex(parent_lower)};
  }
  job.registers = registers;
  return job;
}
constexpr SceneRegisters registers_of(int min_scale, bool figure5 = false, bool relative = false) {
  return {Scale(min_scale), UInt<1>(figure5), UInt<1>(relative)};
}

/// Every pair of codes under every parent.
template <int N>
std::size_t expect_equals_golden(golden::ScaleRule rule, golden::Code code) {
  std::size_t checks = 0;
  const golden::GridRules rules{N, -10, rule};
  const bool figure5 = rule == golden::ScaleRule::figure5;
  constexpr std::int64_t kFarthest = std::int64_t{2} << N;
  for (std::int64_t parent = -kFarthest; parent <= kFarthest; parent += N > 4 ? 13 : 1) {
    for (unsigned lo = 0; lo < 1U << N; ++lo) {
      for (unsigned hi = 0; hi < 1U << N; ++hi) {
        const int scale = rules.min_scale + static_cast<int>((lo + hi) % (N + 2));
        const auto result = decode_box<MachineBits, N>(
            axis_job<N>(lo, hi, scale, parent, registers_of(-10, figure5, code == golden::Code::relative)));
        const auto cells = golden::decode_codes<std::int64_t>(
            {static_cast<std::uint8_t>(lo), static_cast<std::uint8_t>(hi)}, parent, code, N);
        const auto span = cells.upper - cells.lower;
        const Status want = span <= 0 ? Status::inverted : span > rules.max_cells() ? Status::too_wide : Status::ok;
        EXPECT_EQ(result.status.value(), static_cast<std::uint64_t>(want));
        ++checks;
        if (want != Status::ok) continue;
        const auto own = golden::own_context(cells, scale, rules);
        for (std::size_t axis = 0; axis < 3; ++axis) {
          EXPECT_EQ(result.box.lower[axis], Float32::of(golden::edge(cells.lower, scale) + 0.0F));
          EXPECT_EQ(result.box.upper[axis], Float32::of(golden::edge(cells.upper, scale) + 0.0F));
          EXPECT_EQ(result.context[axis].scale.value(), own.scale);
          EXPECT_EQ(result.context[axis].lower.value(), own.lower);
        }
        checks += 12;
        if (::testing::Test::HasFailure()) return checks;
      }
    }
  }
  return checks;
}

TEST(BoxDecoder, equals_the_golden_for_every_pair_of_codes_under_every_parent) {
  std::size_t checks = 0;
  for (const auto rule : {golden::ScaleRule::equation2, golden::ScaleRule::figure5}) {
    for (const auto code : {golden::Code::modulo, golden::Code::relative}) {
      checks += expect_equals_golden<2>(rule, code);
      checks += expect_equals_golden<4>(rule, code);
      checks += expect_equals_golden<6>(rule, code);
    }
  }
  EXPECT_GT(checks, 600'000U);
}

/// A child anywhere in a parent of 2^6 cells, and what the compressor made of it.
struct Compressed {
  DecodeJob<6> job;
  AxisResult<6> child;
};
std::vector<Compressed> compressed_children() {
  std::vector<Compressed> result;
  SplitMix64 random(3);
  for (int i = 0; i < 5000; ++i) {
    const auto any_cell = [&] { return static_cast<float>(random.below(1 << 20)) * 0x1p-14F; };
    const int scale = static_cast<int>(random.below(40)) - 20;
    const auto parent = static_cast<std::int64_t>(random.below(200)) - 100;
    const auto at = [&](float cells) { return std::ldexp(std::min(cells, 63.0F) + static_cast<float>(parent), scale); };
    const float a = at(any_cell());
    const float b = at(any_cell());
    const SceneRegisters registers = registers_of(scale - static_cast<int>(random.below(17)), random.below(2) == 0);
    const auto child = compress_axis<MachineBits, 6>(
        {Float32::of(std::min(a, b)), Float32::of(std::max(a, b)), Scale(scale), registers});
    if (child.status.value() != 0) continue;
    const auto lo = static_cast<unsigned>(child.code_lo.value());
    const auto hi = static_cast<unsigned>(child.code_hi.value());
    result.push_back({axis_job<6>(lo, hi, scale, parent, registers), child});
  }
  return result;
}

TEST(BoxDecoder, gives_back_what_the_axis_compressor_encoded) {
  const auto children = compressed_children();
  EXPECT_GT(children.size(), 3000U);
  for (const auto& [job, child] : children) {
    const DecodeResult result = decode_box<MachineBits, 6>(job);
    ASSERT_EQ(result.status.value(), 0U);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      ASSERT_EQ(result.box.lower[axis], child.edge_lo);
      ASSERT_EQ(result.box.upper[axis], child.edge_hi);
      ASSERT_EQ(result.context[axis].scale, child.own_scale);
      ASSERT_EQ(result.context[axis].lower, child.own_lower);
    }
  }
}

TEST(BoxDecoder, a_child_that_ends_at_its_parents_upper_edge_is_decoded_by_its_span_not_by_equal_codes) {
  for (unsigned r = 0; r < 64; ++r) {  // equation 9 as printed: wrong for every r > 0
    const auto result = decode_box<MachineBits, 6>(axis_job<6>((100 + r) % 64, 100 % 64, 0, 100, registers_of(-16)));
    ASSERT_EQ(result.box.lower[0].value(), 100.0F + static_cast<float>(r));
    ASSERT_EQ(result.box.upper[0].value(), 164.0F);
  }
}

void expect_refused(DecodeJob<6> job, Status status) {
  job.node.leaf = UInt<1>(1);
  job.node.pointer = Pointer(77);
  DecodeResult want;
  want.status = StatusBits(static_cast<std::uint64_t>(status));
  EXPECT_EQ((decode_box<MachineBits, 6>(job)), want);
}

TEST(BoxDecoder, refuses_what_no_compressor_writes_with_the_first_reason_and_zeros) {
  constexpr std::int64_t kLimit = 1 << 24;
  expect_refused(axis_job<6>(5, 5, 0, 0, registers_of(-10)), Status::inverted);
  expect_refused(axis_job<6>(6, 5, 0, 0, registers_of(-10)), Status::inverted);
  expect_refused(axis_job<6>(0, 1, 0, kLimit + 64, registers_of(0)), Status::beyond_exactness);
  expect_refused(axis_job<6>(0, 1, 0, -kLimit - 64, registers_of(0)), Status::beyond_exactness);
  expect_refused(axis_job<6>(0, 1, 0, kLimit, registers_of(0)), Status::beyond_exactness);
  expect_refused(axis_job<6>(0, 1, 0, -kLimit, registers_of(-1)), Status::beyond_exactness);  // on its own grid
  expect_refused(axis_job<6>(0, 1, -149, 0, registers_of(-150)), Status::beyond_exactness);
  expect_refused(axis_job<6>(0, 1, -11, 0, registers_of(-10)), Status::scale_below_minimum);
  expect_refused(axis_job<6>(0, 0, 0, 0, registers_of(-10, true)), Status::too_wide);
  EXPECT_EQ((decode_box<MachineBits, 6>(axis_job<6>(63, 0, 0, kLimit - 64, registers_of(0))).status.value()), 0U);
  EXPECT_EQ((decode_box<MachineBits, 6>(axis_job<6>(0, 1, 0, -kLimit, registers_of(0))).status.value()), 0U);
  EXPECT_EQ((decode_box<MachineBits, 6>(axis_job<6>(0, 0, 0, 0, registers_of(-10))).status.value()), 0U);
}

TEST(BoxDecoder, an_edge_of_two_to_the_128_is_infinite_and_the_finest_one_subnormal) {
  const auto far = decode_box<MachineBits, 6>(axis_job<6>(32, 32, 123, -32, registers_of(104)));
  EXPECT_EQ(far.box.lower[0].value(), -std::numeric_limits<float>::infinity());
  EXPECT_EQ(far.box.upper[0].value(), std::numeric_limits<float>::infinity());
  const auto near = decode_box<MachineBits, 6>(axis_job<6>(63, 1, -149, -1, registers_of(-149)));
  EXPECT_EQ(near.box.lower[0].value(), -std::numeric_limits<float>::denorm_min());
  EXPECT_EQ(near.box.upper[0].value(), std::numeric_limits<float>::denorm_min());
}

TEST(BoxDecoder, has_latency_3_and_a_result_every_cycle_and_stalls_change_nothing) {
  std::vector<DecodeJob<6>> stimuli;
  for (const auto& [job, child] : compressed_children()) stimuli.push_back(job);
  const auto run = [&](const Disturbance& disturbance) {
    return testing::run_unit<DecodeJob<6>, DecodeResult>(stimuli, disturbance, [](auto& in, auto& out) {
      return std::make_unique<BoxDecoder<MachineBits, 6>>(in, out);
    });
  };
  const auto quiet = run({});
  ASSERT_EQ(quiet.responses.size(), stimuli.size());
  for (std::size_t i = 0; i < stimuli.size(); ++i) {
    ASSERT_EQ(quiet.latencies()[i], 3U);
    ASSERT_EQ(quiet.given[i], quiet.given[0] + i);
    ASSERT_EQ(quiet.responses[i], (decode_box<MachineBits, 6>(stimuli[i])));
  }
  for (const auto& disturbance : testing::stall_matrix()) EXPECT_EQ(run(disturbance).responses, quiet.responses);
}

}  // namespace
}  // namespace cbvh::rtl
