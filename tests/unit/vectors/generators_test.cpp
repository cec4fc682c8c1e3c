// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// What the generators make.
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "vectors/format/format.h"
#include "vectors/registry.h"
#include "vectors/typed_vector_set.h"
#include "vectors/units/axis_compressor.h"
#include "vectors/units/backtrack_unit.h"
#include "vectors/units/box_decoder.h"
#include "vectors/units/context_stack.h"
#include "vectors/units/node_pair_compressor.h"
#include "vectors/units/scale_estimator.h"
#include "vectors/units/stream_compressor.h"

namespace cbvh::vectors {
namespace {

using rtl::Status;

template <class U>
const TypedVectorSet<U>& typed(const VectorSet& set) {
  return dynamic_cast<const TypedVectorSet<U>&>(set);
}

TEST(Generators, every_class_appears_and_is_the_id_modulo_the_number_of_classes) {
  for (const UnitDescription& unit : units()) {
    const auto set = generate_set(unit.name, {6, 1}, 2 * unit.generated_classes(), 1);
    std::set<std::string_view> seen;
    for (std::size_t i = 0; i < set->size(); ++i) {
      EXPECT_EQ(set->head(i).case_class, set->head(i).id % unit.generated_classes());
      seen.insert(set->class_name(i));
    }
    EXPECT_EQ(seen.size(), unit.generated_classes()) << unit.name;
  }
}

TEST(Generators, class_names_are_words_and_differ) {
  for (const UnitDescription& unit : units()) {
    const std::set<std::string_view> names(unit.classes.begin(), unit.classes.end());
    EXPECT_EQ(names.size(), unit.classes.size()) << unit.name;
    EXPECT_EQ(unit.classes.back(), kCaptured);
    for (const std::string_view name : names) {
      EXPECT_EQ(name.find_first_not_of("abcdefghijklmnopqrstuvwxyz-"), std::string_view::npos) << name;
    }
  }
}

TEST(Generators, the_same_seed_gives_the_same_bytes_and_another_one_others) {
  for (const UnitDescription& unit : units()) {
    const std::uint64_t cases = unit.generated_classes();
    const std::string bytes = serialize(*generate_set(unit.name, {6, 1}, cases, 1), Format::text);
    EXPECT_EQ(serialize(*generate_set(unit.name, {6, 1}, cases, 1), Format::text), bytes);
    EXPECT_NE(serialize(*generate_set(unit.name, {6, 1}, cases, 2), Format::text), bytes);
  }
}

TEST(Generators, shards_together_are_the_whole_and_a_case_does_not_depend_on_the_count) {
  for (const UnitDescription& unit : units()) {
    const std::uint64_t cases = 2 * unit.generated_classes() + 3;
    const auto whole = generate_set(unit.name, {6, 1}, cases, 4);
    const auto longer = generate_set(unit.name, {6, 1}, cases + 5, 4);
    const auto merged = make_set(unit, {6, 1}, 4);
    std::vector<std::unique_ptr<VectorSet>> shards;
    for (std::uint64_t i = 0; i < 3; ++i) shards.push_back(generate_set(unit.name, {6, 1}, cases, 4, {i, 3}));
    for (std::uint64_t id = 0; id < cases; ++id) {
      const VectorSet& shard = *shards[id % 3];
      ASSERT_LT(shard.find(id), shard.size());
      merged->copy_case(shard, shard.find(id));
    }
    EXPECT_TRUE(merged->equals(*whole)) << unit.name;
    const auto prefix = make_set(unit, {6, 1}, 4);
    for (std::size_t i = 0; i < cases; ++i) prefix->copy_case(*longer, i);
    EXPECT_TRUE(prefix->equals(*whole)) << unit.name;
  }
}

TEST(Generators, bad_requests_are_named) {
  const auto error_of = [](auto&& action) -> std::string {
    try {
      action();
    } catch (const golden::InputError& error) {
      return error.what();
    }
    return "no error";
  };
  EXPECT_EQ(error_of([] { generate_set("context_stack", {4, 1}, 1, 1); }), "bits: found 4, want 6 for context_stack");
  EXPECT_EQ(error_of([] {
              generate_set("axis_compressor", {6, 2}, 1, 1);
            }),
            "treelet: found 2, want 1 for axis_compressor");
  EXPECT_EQ(error_of([] {
              generate_set("axis_compressor", {}, 1, 1, {3, 3});
            }),
            "shard: found 3/3, want an index below the count");
  EXPECT_TRUE(error_of([] { generate_set("adder", {}, 1, 1); }).starts_with("unit: unknown unit 'adder'"));
}

TEST(Generators, corners_of_an_axis_are_valid_and_refusals_have_their_status) {
  const std::map<std::string_view, Status> refusals = {{"not-finite", Status::not_finite},
                                                       {"inverted", Status::inverted},
                                                       {"beyond-exactness", Status::beyond_exactness},
                                                       {"scale-below-minimum", Status::scale_below_minimum},
                                                       {"too-wide", Status::too_wide}};
  std::size_t checked = 0;
  const auto check = [&](const VectorSet& set, std::size_t i, std::uint64_t status) {
    if (set.class_name(i) == "any-wires" || set.class_name(i) == "any-codes") return;
    if (set.class_name(i) == "several-reasons") return;
    const auto refusal = refusals.find(set.class_name(i));
    const Status want = refusal == refusals.end() ? Status::ok : refusal->second;
    if (set.class_name(i) == "context-elsewhere") return;
    ASSERT_EQ(status, static_cast<std::uint64_t>(want))
        << set.unit().name << ' ' << set.parameters().bits << ' ' << set.class_name(i) << ' ' << set.head(i).id;
    ++checked;
  };
  for (const int bits : kBuiltBits) {
    with_bits(bits, [&](auto n) {
      constexpr int kN = decltype(n)::value;
      const Parameters parameters{kN, 1};
      const auto axis = generate_set("axis_compressor", parameters, 18 * 100, 1);
      for (std::size_t i = 0; i < axis->size(); ++i) {
        check(*axis, i, typed<AxisCompressor<kN>>(*axis).responses(i)[0].response.status.raw());
      }
      const auto estimates = generate_set("scale_estimator", parameters, 16 * 100, 1);
      for (std::size_t i = 0; i < estimates->size(); ++i) {
        check(*estimates, i, typed<ScaleEstimator<kN>>(*estimates).responses(i)[0].response.status.raw());
      }
      const auto pairs = generate_set("node_pair_compressor", parameters, 20 * 100, 1);
      for (std::size_t i = 0; i < pairs->size(); ++i) {
        check(*pairs, i, typed<NodePairCompressor<kN>>(*pairs).responses(i)[0].response.status.raw());
      }
      const auto nodes = generate_set("box_decoder", parameters, 21 * 100, 1);
      for (std::size_t i = 0; i < nodes->size(); ++i) {
        check(*nodes, i, typed<BoxDecoder<kN>>(*nodes).responses(i)[0].response.status.raw());
      }
    });
  }
  EXPECT_GT(checked, kBuiltBits.size() * 6'200U);
}

TEST(Generators, the_corners_are_what_they_are_called) {
  const auto set = generate_set("axis_compressor", {6, 1}, 18 * 200, 1);
  const auto& axis = typed<AxisCompressor<6>>(*set);
  std::map<std::string_view, std::size_t> seen;
  std::size_t infinite_edges = 0;
  for (std::size_t i = 0; i < set->size(); ++i) {
    const rtl::AxisJob& job = axis.stimuli(i)[0];
    const rtl::AxisResult<6>& result = axis.responses(i)[0].response;
    const std::uint64_t cells = (result.code_hi.raw() - result.code_lo.raw()) & 63;
    const std::string_view name = set->class_name(i);
    if (name == "signed-zero") seen[name] += job.lower.bits == 0x80000000 || job.upper.bits == 0x80000000;
    if (name == "subnormal") seen[name] += (job.lower.bits & 0x7F800000) == 0 && (job.lower.bits & 0x7FFFFF) != 0;
    if (name == "sign-crossing") seen[name] += job.lower.value() < 0 && job.upper.value() > 0;
    if (name == "one-cell") seen[name] += cells == 1;
    if (name == "full-grid") seen[name] += cells == (job.registers.figure5 ? 63 : 0);
    if (name == "power-of-two-size") seen[name] += std::popcount(cells) == 1;
    if (name == "degenerate-axis") seen[name] += job.lower == job.upper;
    if (name == "edge-on-grid") seen[name] += result.edge_lo.value() == job.lower.value();
    if (name == "minimum-scale-saturation") seen[name] += result.own_scale == job.registers.min_scale;
    if (name == "largest-finite") infinite_edges += (result.edge_hi.bits & 0x7FFFFFFF) == 0x7F800000;
  }
  EXPECT_GT(infinite_edges, 20U);
  for (const char* name : {"one-cell", "full-grid", "power-of-two-size", "degenerate-axis", "edge-on-grid",
                           "minimum-scale-saturation", "sign-crossing"}) {
    EXPECT_EQ(seen[name], 200U) << name;
  }
  for (const char* name : {"signed-zero", "subnormal"}) EXPECT_GT(seen[name], 60U) << name;
}

TEST(Generators, children_end_at_their_parents_upper_edge_and_at_the_last_exact_index) {
  const auto set = generate_set("box_decoder", {6, 1}, 21 * 100, 1);
  const auto& nodes = typed<BoxDecoder<6>>(*set);
  std::size_t inside_and_up_to_the_edge = 0;
  std::size_t largest = 0;
  for (std::size_t i = 0; i < set->size(); ++i) {
    const rtl::DecodeJob<6>& job = nodes.stimuli(i)[0];
    const rtl::DecodeResult& result = nodes.responses(i)[0].response;
    if (result.status.raw() != 0) continue;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::uint64_t origin = job.registers.relative ? 0 : job.parent[axis].lower.raw() & 63;
      const bool ends_at_edge = job.node.hi[axis].raw() == origin && job.node.lo[axis].raw() != origin;
      if (set->class_name(i) == "parents-upper-edge") inside_and_up_to_the_edge += ends_at_edge;
      if (set->class_name(i) == "largest-index") largest += std::abs(result.context[axis].lower.value()) == 1 << 24;
    }
  }
  EXPECT_GT(inside_and_up_to_the_edge, 280U);
  EXPECT_GT(largest, 60U);
}

TEST(Generators, the_stack_overflows_and_underflows) {
  const auto set = generate_set("context_stack", {}, 70, 1);
  std::map<std::uint64_t, std::size_t> statuses;
  std::size_t full = 0;
  for (const auto& reply : typed<ContextStack<6>>(*set).responses()) {
    ++statuses[reply.response.status.raw()];
    full += reply.response.depth.raw() == rtl::kContextStackDepth;
  }
  EXPECT_EQ(statuses.size(), 3U);
  EXPECT_GT(full, 10U);
}

TEST(Generators, streams_repair_are_refused_and_come_in_twos_and_more) {
  for (const int treelet : {1, 2, 4}) {
    const auto set = generate_set("stream_compressor", {6, treelet}, 23 * 8, 1);
    std::map<std::uint64_t, std::size_t> statuses;
    std::size_t repairs = 0;
    for (std::size_t i = 0; i < set->size(); ++i) {
      std::size_t reports = 0;
      for (const auto& event : typed<StreamCompressor<6>>(*set).responses(i)) {
        repairs += event.response.kind.raw() == 0;
        if (event.response.kind.raw() != 2) continue;
        ++reports;
        ++statuses[event.response.report.status.raw()];
      }
      const bool two = set->class_name(i) == "two-trees" || set->class_name(i) == "refused-then-valid";
      if (set->class_name(i) == "small-trees") {
        EXPECT_GE(reports, 3U);
      } else {
        EXPECT_EQ(reports, two ? 2U : 1U) << set->class_name(i);
      }
    }
    EXPECT_GT(repairs, treelet == 4 ? 1U : 30U) << treelet;
    for (const Status status :
         {Status::ok, Status::not_finite, Status::inverted, Status::beyond_exactness, Status::overflow}) {
      EXPECT_GT(statuses[static_cast<std::uint64_t>(status)], 0U) << static_cast<int>(status);
    }
  }
}

TEST(Generators, backtracking_stops_at_once_goes_deep_and_takes_both_children) {
  const auto set = generate_set("backtrack_unit", {2, 1}, 16 * 20, 1);
  std::map<std::string_view, std::size_t> deepest;
  for (std::size_t i = 0; i < set->size(); ++i) {
    for (const auto& event : typed<BacktrackUnit<2>>(*set).responses(i)) {
      if (!event.response.done) continue;
      std::size_t& most = deepest[set->class_name(i)];
      most = std::max(most, static_cast<std::size_t>(event.response.repairs.raw()));
    }
  }
  EXPECT_EQ(deepest["leaf-pair"], 1U);
  EXPECT_GT(deepest["both-children"], 2U);
  EXPECT_GT(deepest["left-spine"], 12U);
  EXPECT_GT(deepest["right-spine"], 12U);
  EXPECT_GE(deepest["from-stream"], 1U);
  EXPECT_EQ(deepest["no-change"], 1U);
}

}  // namespace
}  // namespace cbvh::vectors
