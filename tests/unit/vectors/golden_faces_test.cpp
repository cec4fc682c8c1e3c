// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// The golden faces against restatements in rational arithmetic, and against golden's own compressors of whole trees.
#include <gtest/gtest.h>

#include "golden/build/lbvh.h"
#include "golden/scene/trouble_scenes.h"
#include "golden/update/streaming.h"
#include "golden/update/top_down.h"
#include "tests/unit/golden/random_floats.h"
#include "vectors/generate/float_trees.h"
#include "vectors/registry.h"
#include "vectors/typed_vector_set.h"
#include "vectors/units/axis_compressor.h"
#include "vectors/units/box_decoder.h"
#include "vectors/units/context_stack.h"
#include "vectors/units/scale_estimator.h"
#include "vectors/units/stream_compressor.h"

namespace cbvh::vectors {
namespace {

using golden::test::floor_of;
using golden::test::Integer;
using golden::test::Rational;
using golden::test::two_to;
using rtl::Status;

/// A finite float as the fraction it is.
Rational rational(rtl::Float32 x) { return Rational(static_cast<double>(x.value())); }

/// The place value of a float's last bit.
int last_place(rtl::Float32 x) {
  const int exponent = static_cast<int>((x.bits >> 23) & 0xFF);
  return std::max(exponent, 1) - 150;
}

/// k and l by definition.
std::pair<Integer, Integer> cells(const rtl::Float32& lower, const rtl::Float32& upper, int scale) {
  return {floor_of(rational(lower) / two_to(scale)), floor_of(rational(upper) / two_to(scale)) + 1};
}

Status naive_status(rtl::Float32 lower, rtl::Float32 upper, const rtl::SceneRegisters& registers) {
  const auto is_special = [](rtl::Float32 x) { return ((x.bits >> 23) & 0xFF) == 0xFF; };
  if (is_special(lower) || is_special(upper)) return Status::not_finite;
  if (rational(lower) > rational(upper)) return Status::inverted;
  if (registers.min_scale.value() < std::max(last_place(lower), last_place(upper))) return Status::beyond_exactness;
  return Status::ok;
}

std::uint64_t modulo(const Integer& index, int bits) {
  const Integer size = Integer{1} << static_cast<unsigned>(bits);
  return static_cast<std::uint64_t>(Integer(((index % size) + size) % size));
}

template <int N>
void expect_axis(const rtl::AxisJob& job, const rtl::AxisResult<N>& result) {
  const int scale = static_cast<int>(job.scale.value());
  const int finest = static_cast<int>(job.registers.min_scale.value());
  const Integer most = (1 << N) - (job.registers.figure5 ? 1 : 0);
  Status status = naive_status(job.lower, job.upper, job.registers);
  Integer k;
  Integer l;
  if (status == Status::ok && scale < finest) status = Status::scale_below_minimum;
  if (status == Status::ok) {
    std::tie(k, l) = cells(job.lower, job.upper, scale);
    if (l - k > most) status = Status::too_wide;
  }
  ASSERT_EQ(result.status.raw(), static_cast<std::uint64_t>(status));
  if (status != Status::ok) {
    rtl::AxisResult<N> refused;
    refused.status = result.status;
    ASSERT_EQ(result, refused) << "everything else is zero";
    return;
  }
  int own = scale;
  while (own > finest && Rational(l - k) * two_to(scale - own + 1) <= Rational(most)) --own;
  ASSERT_EQ(result.code_lo.raw(), modulo(k, N));
  ASSERT_EQ(result.code_hi.raw(), modulo(l, N));
  ASSERT_EQ(result.own_scale.value(), own);
  ASSERT_EQ(Rational(result.own_lower.value()), Rational(k) * two_to(scale - own));
  const auto expect_edge = [scale](rtl::Float32 edge, const Integer& index) {
    const Rational exact = Rational(index) * two_to(scale);
    if (abs(exact) >= two_to(128)) {
      ASSERT_EQ(edge.bits, exact > 0 ? 0x7F800000U : 0xFF800000U);
    } else {
      ASSERT_EQ(rational(edge), exact);
      ASSERT_NE(edge.bits, 0x80000000U);
    }
  };
  expect_edge(result.edge_lo, k);
  expect_edge(result.edge_hi, l);
}

TEST(GoldenFaces, axis_compressor_is_the_rules_in_rational_arithmetic) {
  for (const int bits : kBuiltBits) {
    with_bits(bits, [](auto n) {
      constexpr int kN = decltype(n)::value;
      const auto set = generate_set("axis_compressor", {kN, 1}, 18 * 60, 21);
      const auto& axis = dynamic_cast<const TypedVectorSet<AxisCompressor<kN>>&>(*set);
      for (std::size_t i = 0; i < set->size(); ++i) {
        SCOPED_TRACE(fmt::format("bits {} case {} {}", kN, i, set->class_name(i)));
        expect_axis<kN>(axis.stimuli(i)[0], axis.responses(i)[0].response);
        if (testing::Test::HasFatalFailure()) return;
      }
    });
  }
}

TEST(GoldenFaces, scale_estimator_is_the_smallest_scale_that_fits) {
  std::size_t estimates = 0;
  with_bits(6, [&](auto n) {
    constexpr int kN = decltype(n)::value;
    const auto set = generate_set("scale_estimator", {kN, 1}, 16 * 60, 22);
    const auto& all = dynamic_cast<const TypedVectorSet<ScaleEstimator<kN>>&>(*set);
    for (std::size_t i = 0; i < set->size(); ++i) {
      const rtl::EstimateJob& job = all.stimuli(i)[0];
      const rtl::EstimateResult& result = all.responses(i)[0].response;
      const Status status = naive_status(job.lower, job.upper, job.registers);
      ASSERT_EQ(result.status.raw(), static_cast<std::uint64_t>(status));
      if (status != Status::ok) continue;
      int scale = static_cast<int>(job.registers.min_scale.value());
      const Integer most = (1 << kN) - (job.registers.figure5 ? 1 : 0);
      for (;; ++scale) {
        const auto [k, l] = cells(job.lower, job.upper, scale);
        if (l - k <= most) break;
      }
      ASSERT_EQ(result.scale.value(), scale) << i;
      ASSERT_EQ(Integer(result.lower.value()), cells(job.lower, job.upper, scale).first) << i;
      ++estimates;
    }
  });
  EXPECT_GT(estimates, 600U);
}

/// One axis of a decoded child against the definitions: k and l are the indices within the parent's reach that have
/// these codes, the own grid is the finest that holds them.
void expect_decoded(const rtl::DecodeResult& result, std::size_t axis, unsigned lo, unsigned hi,
                    const rtl::AxisContext& parent, const rtl::SceneRegisters& registers, int bits) {
  const std::int64_t capacity = std::int64_t{1} << bits;
  const std::int64_t origin = registers.relative ? parent.lower.value() : 0;
  const auto index_from = [&](std::int64_t first, unsigned code) {
    while ((first - origin - code) % capacity != 0) ++first;
    return first;
  };
  const std::int64_t k = index_from(parent.lower.value(), lo);
  const std::int64_t l = index_from(parent.lower.value() + 1, hi);
  const int scale = static_cast<int>(parent.scale.value());
  const auto expect_edge = [&](rtl::Float32 found, std::int64_t index) {
    const Rational exact = Rational(index) * two_to(scale);
    if (abs(exact) >= two_to(128)) {
      ASSERT_EQ(found.bits, index > 0 ? 0x7F800000U : 0xFF800000U);
    } else {
      ASSERT_EQ(rational(found), exact);
      ASSERT_EQ(found.bits == 0x80000000U, false);
    }
  };
  expect_edge(result.box.lower[axis], k);
  expect_edge(result.box.upper[axis], l);
  const Integer most = capacity - (registers.figure5 ? 1 : 0);
  int own = std::max(static_cast<int>(registers.min_scale.value()), scale - 12);
  while (Rational(l - k) * two_to(scale - own) > Rational(most)) ++own;
  ASSERT_LE(own, scale);
  ASSERT_EQ(result.context[axis].scale.value(), own);
  ASSERT_EQ(Rational(result.context[axis].lower.value()) * two_to(own), Rational(k) * two_to(scale));
}

TEST(GoldenFaces, box_decoder_gives_the_indices_that_have_these_codes_as_exact_floats_and_the_finest_grid) {
  std::size_t decoded = 0;
  for (const int bits : kBuiltBits) {
    with_bits(bits, [&](auto n) {
      constexpr int kN = decltype(n)::value;
      const auto set = generate_set("box_decoder", {kN, 1}, 21 * 30, 23);
      const auto& all = dynamic_cast<const TypedVectorSet<BoxDecoder<kN>>&>(*set);
      for (std::size_t i = 0; i < set->size(); ++i) {
        const rtl::DecodeJob<kN>& job = all.stimuli(i)[0];
        const rtl::DecodeResult& result = all.responses(i)[0].response;
        if (result.status.raw() != 0) {
          rtl::DecodeResult refused;
          refused.status = result.status;
          ASSERT_EQ(result, refused);
          continue;
        }
        for (std::size_t axis = 0; axis < 3; ++axis) {
          const auto lo = static_cast<unsigned>(job.node.lo[axis].raw());
          const auto hi = static_cast<unsigned>(job.node.hi[axis].raw());
          expect_decoded(result, axis, lo, hi, job.parent[axis], job.registers, kN);
          if (testing::Test::HasFatalFailure()) return;
        }
        ASSERT_EQ(result.leaf, job.node.leaf);
        ASSERT_EQ(result.pointer, job.node.pointer);
        ++decoded;
      }
    });
  }
  EXPECT_GT(decoded, kBuiltBits.size() * 420U);
}

TEST(GoldenFaces, context_stack_refusals_change_nothing) {
  std::vector<rtl::StackOperation> operations;
  const auto operate = [&](std::uint64_t pops, bool push, int scale) {
    rtl::Context context{};
    context[0].scale = rtl::Scale(scale);
    operations.push_back({rtl::UInt<2>(pops), rtl::UInt<1>(push), context});
  };
  operate(1, true, 1);  // underflow
  operate(0, true, 2);
  operate(3, true, 3);   // underflow
  operate(2, false, 4);  // underflow
  operate(0, true, 5);
  operate(2, true, 6);                                                    // takes 5 and 2
  for (int i = 0; i < rtl::kContextStackDepth; ++i) operate(0, true, 7);  // the last overflows
  operate(1, true, 8);
  const auto replies = ContextStack<6>::respond(operations, {});
  ASSERT_EQ(replies.size(), operations.size());
  const auto status = [&](std::size_t i) { return static_cast<Status>(replies[i].response.status.raw()); };
  EXPECT_EQ(status(0), Status::underflow);
  EXPECT_EQ(status(2), Status::underflow);
  EXPECT_EQ(status(3), Status::underflow);
  EXPECT_EQ(replies[3].response.depth.raw(), 1U);
  EXPECT_EQ(replies[3].response.popped[0], rtl::Context{});
  EXPECT_EQ(replies[5].response.popped[0][0].scale.value(), 5);
  EXPECT_EQ(replies[5].response.popped[1][0].scale.value(), 2);
  EXPECT_EQ(replies[5].response.depth.raw(), 1U);
  EXPECT_EQ(status(5 + rtl::kContextStackDepth - 1), Status::ok);
  EXPECT_EQ(status(5 + rtl::kContextStackDepth), Status::overflow);
  EXPECT_EQ(replies[5 + rtl::kContextStackDepth].response.depth.raw(), 32U);
  EXPECT_EQ(status(6 + rtl::kContextStackDepth), Status::ok);
  EXPECT_EQ(replies[6].latency, 7U);
}

/// What golden's own streaming compressor did.
struct Observed {
  std::vector<std::uint32_t> finals;
  std::vector<RepairedPair> repairs;
};

void expect_same_stream(const golden::FloatTree& tree, const golden::GridRules& rules, golden::Code code, int levels) {
  Observed observed;
  golden::StreamingObserver observer;
  observer.on_final = [&](std::uint32_t index, const auto&, const auto&) { observed.finals.push_back(index); };
  observer.on_repair = [&](std::uint32_t index, const auto&, const golden::CompressedPair& pair, const auto&,
                           const auto&) {
    observed.repairs.push_back({index, pair, 0});
  };
  golden::compress_streaming(tree, rules, code, levels, &observer);
  const golden::CompressedTree top_down = golden::compress_top_down(tree, rules, code);

  const rtl::SceneRegisters registers{rtl::Scale(rules.min_scale),
                                      rtl::UInt<1>(rules.scale_rule == golden::ScaleRule::figure5),
                                      rtl::UInt<1>(code == golden::Code::relative)};
  const auto jobs = stream_of(tree, registers);
  const auto finals = collect(jobs, levels, rules.bits);
  ASSERT_EQ(finals.size(), observed.finals.size());
  for (std::size_t i = 0; i < finals.size(); ++i) ASSERT_EQ(finals[i].index, observed.finals[i]) << i;
  ASSERT_TRUE(finals.back().last);
  with_bits(rules.bits, [&](auto n) {
    constexpr int kN = decltype(n)::value;
    using Kind = typename StreamEvent<kN>::Kind;
    const auto events = StreamCompressor<kN>::respond(jobs, {kN, levels});
    ASSERT_EQ(events.size(), observed.repairs.size() + tree.pairs.size() + 1);
    for (std::size_t i = 0; i < events.size(); ++i) {
      const StreamEvent<kN>& event = events[i].response;
      if (i < observed.repairs.size()) {
        ASSERT_EQ(event.kind.raw(), static_cast<std::uint64_t>(Kind::repair));
        ASSERT_EQ(event.index.raw(), observed.repairs[i].index);
        ASSERT_EQ(event.pair, to_wires<kN>(observed.repairs[i].pair));
      } else if (i + 1 < events.size()) {
        const std::size_t index = i - observed.repairs.size();
        ASSERT_EQ(event.kind.raw(), static_cast<std::uint64_t>(Kind::memory));
        ASSERT_EQ(event.index.raw(), index);
        ASSERT_EQ(event.pair, to_wires<kN>(top_down.pairs[index]));
      } else {
        ASSERT_EQ(event.kind.raw(), static_cast<std::uint64_t>(Kind::report));
        ASSERT_EQ(event.report.repairs.raw(), observed.repairs.size());
        ASSERT_EQ(event.report.last_index.raw(), tree.pairs.size() - 1);
        for (std::size_t axis = 0; axis < 3; ++axis) {
          ASSERT_EQ(event.report.root[axis].scale.value(), top_down.root[axis].scale);
          ASSERT_EQ(golden::Wide{event.report.root[axis].lower.value()}, top_down.root[axis].lower);
        }
      }
    }
  });
}

TEST(GoldenFaces, streams_equal_golden_streaming_and_top_down_compression) {
  std::size_t trees = 0;
  for (const golden::Trouble trouble : golden::kTroubles) {
    for (std::uint64_t seed = 0; seed < 6; ++seed) {
      const golden::FloatTree tree = golden::build_lbvh(golden::trouble_scene(trouble, seed, 40));
      if (tree.pairs.empty()) continue;
      const int finest = golden::exactness_limit(tree.largest_magnitude) + static_cast<int>(seed % 3) * 4;
      const auto rule = seed % 2 == 0 ? golden::ScaleRule::equation2 : golden::ScaleRule::figure5;
      for (const golden::Code code : {golden::Code::modulo, golden::Code::relative}) {
        for (const int levels : {1, 2, 3, 8}) {
          const int bits = kBuiltBits.at((seed + static_cast<std::uint64_t>(levels)) % kBuiltBits.size());
          SCOPED_TRACE(fmt::format("{} seed {} levels {} bits {}", golden::name_of(trouble), seed, levels, bits));
          expect_same_stream(tree, {bits, finest, rule}, code, levels);
          if (testing::Test::HasFatalFailure()) return;
          ++trees;
        }
      }
    }
  }
  EXPECT_GT(trees, 300U);
}

TEST(GoldenFaces, a_refused_pair_silences_the_rest_of_its_tree_only) {
  Random random(7);
  std::vector<rtl::StreamJob> jobs =
      random_tree(TreeShape::balanced, TreePlaces::halved, 4, random).finish({rtl::Scale(-149), {}, {}});
  const std::size_t size = jobs.size();
  const auto valid = collect(jobs, 1, 6);
  ASSERT_EQ(valid.size(), size);
  const std::vector<rtl::StreamJob> good = jobs;
  jobs[5].pair.box[1].upper[2] = {0x7FC00000};
  jobs[9].pair.box[0].lower[0] = {0x7F800000};
  jobs.insert(jobs.end(), good.begin(), good.end());
  const auto finals = collect(jobs, 1, 6);
  ASSERT_EQ(finals.size(), 5 + 1 + size);
  for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(finals[i].pair, valid[i].pair);
  EXPECT_EQ(finals[5].index, 5U);
  EXPECT_EQ(finals[5].status, Status::not_finite);
  EXPECT_TRUE(finals[5].last);
  EXPECT_EQ(finals[5].pair, golden::CompressedPair{});
  for (std::size_t i = 0; i < size; ++i) EXPECT_EQ(finals[6 + i].pair, valid[i].pair);
  const auto events = StreamCompressor<6>::respond(jobs, {6, 1});
  EXPECT_EQ(events[0].response.report.last_index.raw(), 5U);
  EXPECT_EQ(events[0].response.report.status.raw(), static_cast<std::uint64_t>(Status::not_finite));
  EXPECT_EQ(events[0].response.report.repairs.raw(), 0U);
}

TEST(GoldenFaces, a_wrong_response_is_found_and_named) {
  const auto set = generate_set("axis_compressor", {}, 100, 1);
  auto episode = dynamic_cast<const TypedVectorSet<AxisCompressor<6>>&>(*set).episode(40);
  auto other = make_set(set->unit(), set->parameters(), 1);
  auto& spoiled = dynamic_cast<TypedVectorSet<AxisCompressor<6>>&>(*other);
  episode.responses[0].response.own_scale = rtl::Scale(episode.responses[0].response.own_scale.value() ^ 1);
  spoiled.add(episode);
  episode = dynamic_cast<const TypedVectorSet<AxisCompressor<6>>&>(*set).episode(41);
  episode.responses[0].latency = 4;
  spoiled.add(episode);
  episode = dynamic_cast<const TypedVectorSet<AxisCompressor<6>>&>(*set).episode(42);
  episode.responses[0].latency = kLatencyNotStated;
  spoiled.add(episode);
  const Verification verification = spoiled.verify();
  EXPECT_EQ(verification.mismatches, 2U);
  EXPECT_EQ(verification.first[0].id, 40U);
  EXPECT_TRUE(verification.first[0].what.starts_with("field 'own_scale': found ")) << verification.first[0].what;
  EXPECT_EQ(verification.first[1].what, "latency: found 4, want 3");
  EXPECT_EQ(verification.counts.latencies, 2U);
  EXPECT_EQ(verification.counts.latencies_unstated, 1U);
  EXPECT_EQ(verification.counts.checks, 21U);
}

}  // namespace
}  // namespace cbvh::vectors
