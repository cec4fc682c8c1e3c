// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// The errata of docs/arithmetic.md in the datapaths. tests/errata/put_back.sh puts each printed form back into a copy
// of the sources and demands that the test named there fails.
#include <gtest/gtest.h>

#include "rtl_model/compress/lazy_treelet_collector.h"
#include "rtl_model/compress/treelet_collector.h"
#include "rtl_model/datapath/pair_compress.h"
#include "rtl_model/datapath/reencode.h"
#include "tests/support/unit_run.h"

namespace cbvh::rtl {
namespace {

constexpr SceneRegisters registers(int min_scale, bool figure5 = false, bool relative = false) {
  return {Scale(min_scale), UInt<1>(figure5), UInt<1>(relative)};
}
AxisResult<6> compress(float lower, float upper, int scale, bool figure5 = false) {
  return compress_axis<MachineBits, 6>({Float32::of(lower), Float32::of(upper), Scale(scale), registers(-17, figure5)});
}
constexpr AxisContext axis_context(int scale, int lower) { return {Scale(scale), CellIndex(lower)}; }

TEST(HardwareErrata, full_span_is_told_by_the_span_alone) {
  for (int r = 0; r < 64; ++r) {  // a child from cell 100 + r to the parent's upper edge
    const auto cells = decode_codes<MachineBits, 6>(UInt<6>((100u + static_cast<unsigned>(r)) % 64), UInt<6>(100 % 64),
                                                    CellIndex(100), UInt<1>(0));
    EXPECT_EQ(cells.lower.value(), 100 + r);
    EXPECT_EQ(cells.upper.value(), 164);
  }
}

TEST(HardwareErrata, a_size_that_is_a_power_of_two_fills_the_finer_grid) {
  for (int exponent = 0; exponent <= 5; ++exponent) {
    const float cells = static_cast<float>(1 << exponent);
    EXPECT_EQ(compress(0, cells - 0.5f, 0).own_scale.value(), exponent - 6);
    EXPECT_EQ(compress(0, cells - 0.5f, 0, true).own_scale.value(), exponent - 5)
        << "the printed loop, kept for comparison";
  }
  EXPECT_EQ(compress(0, 63.5f, 0).own_scale.value(), 0);
}

TEST(HardwareErrata, alignment_of_a_negative_number_rounds_towards_minus_infinity) {
  const auto result = compress(-1.5f, -0.25f, 0);
  EXPECT_EQ(result.code_lo.value(), 62u);
  EXPECT_EQ(result.code_hi.value(), 0u);
  EXPECT_EQ(result.edge_lo.value(), -2.0f);
  EXPECT_EQ(result.edge_hi.value(), 0.0f);
}

TEST(HardwareErrata, a_negative_edge_is_packed_as_sign_and_magnitude) {
  EXPECT_EQ(compress(-40, -3, 0).edge_lo.value(), -40.0f);
  EXPECT_EQ(compress(-40, -3, 0).edge_hi.value(), -2.0f);
}

TEST(HardwareErrata, the_upper_edge_is_packed_from_the_upper_index) {
  EXPECT_EQ(compress(1, 7.5f, 0).edge_hi.value(), 8.0f);
}

TEST(HardwareErrata, re_encoding_takes_the_ceiling_of_an_upper_edge) {
  const CellPair<MachineBits> full{CellIndex(-128), CellIndex(-64)};
  EXPECT_EQ(coarsen<MachineBits>(full, UInt<5>(0)).upper.value(), -64);
  EXPECT_EQ(coarsen<MachineBits>(full, UInt<5>(1)).upper.value(), -32);
  EXPECT_EQ(coarsen<MachineBits>({CellIndex(-128), CellIndex(-63)}, UInt<5>(1)).upper.value(), -31);
}

TEST(HardwareErrata, an_estimate_fits_where_the_exponent_of_the_size_alone_does_not) {
  // 1 .. 64.5 has a size below 64, yet touches 64 cells from 1 to 64 inclusive; 0.5 .. 64.25 touches 65 of them.
  const auto estimate = [](float lower, float upper) {
    return estimate_scale<MachineBits, 6>({Float32::of(lower), Float32::of(upper), registers(-17)}).scale.value();
  };
  EXPECT_EQ(estimate(1, 64.5f), 0);
  EXPECT_EQ(estimate(0.5f, 64.25f), 1);
}

TEST(HardwareErrata, relative_codes_need_the_lower_index_compared_too) {
  const Context before = {axis_context(3, 10), axis_context(3, 20), axis_context(3, 30)};
  Context moved = before;
  moved[1].lower = CellIndex(19);
  EXPECT_EQ(invalidates<MachineBits>(before, moved, UInt<1>(1)).value(), 1u);
  EXPECT_EQ(invalidates<MachineBits>(before, moved, UInt<1>(0)).value(), 0u);
  moved[1] = axis_context(4, 10);
  EXPECT_EQ(invalidates<MachineBits>(before, moved, UInt<1>(0)).value(), 1u);
}

TEST(HardwareErrata, each_child_is_compressed_from_its_own_box) {
  PairJob job;
  job.registers = registers(-17);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    job.pair.box[0].upper[axis] = Float32::of(10.5f);
    job.pair.box[1].lower[axis] = Float32::of(20.5f);
    job.pair.box[1].upper[axis] = Float32::of(40.5f);
  }
  const auto result = compress_pair<MachineBits, 6>(job);
  EXPECT_EQ(result.pair.child[0].hi[0].value(), 11u);
  EXPECT_EQ(result.pair.child[1].lo[0].value(), 20u);
  EXPECT_EQ(result.pair.child[1].hi[2].value(), 41u);
}

/// Two leaf pairs and the pair above them.
std::vector<StreamJob> three_pairs() {
  std::vector<StreamJob> jobs(3);
  for (auto& job : jobs) {
    job.registers = registers(-17);
    job.pair.leaf = {UInt<1>(1), UInt<1>(1)};
  }
  jobs[2].pair.leaf = {UInt<1>(0), UInt<1>(0)};
  jobs[2].pair.pointer = {Pointer(0), Pointer(1)};
  jobs[2].root = UInt<1>(1);
  return jobs;
}

template <template <class, int> class Collector>
void expect_inner_children_taken(int levels) {
  const auto jobs = three_pairs();
  const auto observed = testing::run_unit<StreamJob, FinalPair<6>>(
      jobs, {}, [levels](auto& in, auto& out) { return std::make_unique<Collector<MachineBits, 6>>(in, out, levels); });
  ASSERT_EQ(observed.responses.size(), 3u);
  for (const auto& response : observed.responses) EXPECT_EQ(response.status.value(), 0u);
  EXPECT_EQ(observed.responses.back().last.value(), 1u);
}
TEST(HardwareErrata, contexts_are_taken_off_the_stack_for_inner_children_only) {
  expect_inner_children_taken<TreeletCollector>(1);
  expect_inner_children_taken<LazyTreeletCollector>(1);
}

TEST(HardwareErrata, a_treelet_of_m_levels_holds_two_to_the_m_minus_one_pairs) {
  for (int levels = 1; levels <= 8; ++levels) {
    const auto order = pre_order(levels);
    EXPECT_EQ(order.size(), (std::size_t{1} << levels) - 1);
  }
  EXPECT_EQ(graft(1, 0), 2u);
  EXPECT_EQ(graft(1, 1), 3u);
  EXPECT_EQ(graft(5, 1), 13u);
}

TEST(HardwareErrata, a_minimum_scale_finer_than_a_last_place_is_refused) {
  const auto result = compress_axis<MachineBits, 6>({Float32::of(1), Float32::of(1), Scale(-20), registers(-24)});
  EXPECT_EQ(result.status.value(), static_cast<std::uint64_t>(Status::beyond_exactness));
}

}  // namespace
}  // namespace cbvh::rtl
