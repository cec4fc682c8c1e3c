// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/scoreboard/scoreboard.h"

#include <gtest/gtest.h>

#include "rtl_model/datapath/payloads.h"
#include "testbench/backend/backend.h"
#include "testbench/regression/check_set.h"
#include "testbench/rtl/in_out_bench.h"
#include "testbench/scoreboard/minimise.h"
#include "testbench/scoreboard/subtree.h"
#include "vectors/registry.h"

namespace cbvh::testbench {
namespace {

using rtl::AxisJob;
using Result = rtl::AxisResult<6>;

std::string no_rerun(std::uint64_t) { return ""; }

/// Gives the responses of the set itself, spoiled by `spoil(responses of one case)`.
class SpoiledBackend final : public Backend {
 public:
  using Spoil = std::function<void(std::size_t index, std::vector<vectors::Expected<Result>>& responses, bool& hung)>;
  explicit SpoiledBackend(Spoil spoil) : spoil_(std::move(spoil)) {}
  std::string name() const override { return "spoiled"; }
  bool has(const vectors::UnitDescription&) const override { return true; }
  Responses run(const vectors::VectorSet& set, const RunOptions&) const override {
    Responses responses(sizeof(Result));
    for (std::size_t index = 0; index < set.size(); ++index) {
      std::vector<vectors::Expected<Result>> given(1);
      given[0].response = *static_cast<const Result*>(set.response_at(index));
      given[0].latency = set.latency_at(index);
      bool hung = false;
      spoil_(index, given, hung);
      for (const auto& [response, latency] : given) responses.add(&response, latency);
      responses.end_case(hung);
    }
    return responses;
  }

 private:
  Spoil spoil_;
};

SetReport check(const SpoiledBackend::Spoil& spoil, const RunOptions& options = {}) {
  const auto set = vectors::generate_set("axis_compressor", {}, 20, 3);
  SetReport report;
  report.unit = "axis_compressor";
  report.set = "test";
  check_set(*set, SpoiledBackend(spoil), options, no_rerun, report);
  return report;
}

constexpr std::uint64_t kChecksPerCase = 7 + 1;  // fields and the latency

TEST(Scoreboard, counts_a_check_for_every_field_and_stated_latency) {
  const SetReport report = check([](auto, auto&, auto&) {});
  EXPECT_EQ(report.cases, 20u);
  EXPECT_EQ(report.checks, 20 * kChecksPerCase);
  EXPECT_EQ(report.failures, 0u);
  EXPECT_TRUE(report.mismatches.empty());
}

TEST(Scoreboard, names_the_field_that_differs) {
  const SetReport report = check([](std::size_t index, auto& given, auto&) {
    if (index == 4) given[0].response.own_scale = rtl::Scale::of_raw(given[0].response.own_scale.raw() ^ 1);
  });
  EXPECT_EQ(report.failures, 1u);
  ASSERT_EQ(report.mismatches.size(), 1u);
  EXPECT_EQ(report.mismatches[0].field, "own_scale");
  EXPECT_EQ(report.mismatches[0].id, 4u);
  EXPECT_FALSE(report.mismatches[0].case_class.empty());
}

TEST(Scoreboard, catches_a_wrong_latency_and_under_stalls_an_early_response) {
  const auto late = [](std::size_t index, auto& given, auto&) { given[0].latency += index == 7; };
  const SetReport report = check(late);
  EXPECT_EQ(report.failures, 1u);
  ASSERT_FALSE(report.mismatches.empty());
  EXPECT_EQ(report.mismatches[0].field, "latency");
  EXPECT_EQ(report.mismatches[0].found, "4");
  EXPECT_EQ(report.mismatches[0].wanted, "3");
  RunOptions stalled;
  stalled.stalls = Stalls::both;
  EXPECT_EQ(check(late, stalled).failures, 0u);
  EXPECT_EQ(check(late, stalled).checks, 20 * kChecksPerCase);
  const auto early = [](std::size_t index, auto& given, auto&) { given[0].latency -= index == 7; };
  EXPECT_EQ(check(early, stalled).failures, 1u);
}

TEST(Scoreboard, fails_every_check_of_a_missing_response) {
  const SetReport report = check([](std::size_t index, auto& given, auto&) {
    if (index == 2) given.clear();
  });
  EXPECT_EQ(report.checks, 20 * kChecksPerCase);
  EXPECT_EQ(report.failures, kChecksPerCase);
  ASSERT_FALSE(report.mismatches.empty());
  EXPECT_EQ(report.mismatches[0].field, "missing response");
}

TEST(Scoreboard, fails_surplus_responses_and_hangs) {
  const SetReport surplus = check([](std::size_t index, auto& given, auto&) {
    if (index == 2) given.push_back(given[0]);
  });
  EXPECT_EQ(surplus.failures, 1u);
  EXPECT_EQ(surplus.mismatches.at(0).field, "surplus response");
  const SetReport hang = check([](std::size_t index, auto& given, bool& hung) {
    hung = index == 19;
    if (hung) given.clear();
  });
  EXPECT_EQ(hang.failures, kChecksPerCase);
  EXPECT_EQ(hang.mismatches.at(0).field, "hang");
}

TEST(Minimise, drives_the_fields_that_do_not_matter_to_zero) {
  // The fault shows wherever the upper bound is negative; the smallest such case has nothing else in it.
  const auto set = vectors::generate_set("axis_compressor", {}, 200, 3);
  const auto negative = [](const vectors::VectorSet& one) {
    return static_cast<const AxisJob*>(one.stimulus_at(0))->upper.bits >> 31 != 0;
  };
  std::size_t index = 0;
  while (static_cast<const AxisJob*>(set->stimulus_at(index))->upper.bits >> 31 == 0) ++index;
  const auto smaller = minimise(*set, index, negative);
  ASSERT_EQ(smaller->size(), 1u);
  const auto& job = *static_cast<const AxisJob*>(smaller->stimulus_at(0));
  EXPECT_TRUE(negative(*smaller));
  EXPECT_EQ(job.lower.bits, 0u);
  EXPECT_EQ(job.scale.raw(), 0u);
  EXPECT_EQ(job.registers.min_scale.raw(), 0u);
}

TEST(Minimise, drops_the_steps_of_an_episode_that_do_not_matter) {
  const auto set = vectors::generate_set("context_stack", {}, 40, 3);
  const auto pushes = [](const vectors::VectorSet& one) {
    int count = 0;
    for (std::size_t i = 0; i < one.stimulus_count(); ++i) {
      count += bool(static_cast<const rtl::StackOperation*>(one.stimulus_at(i))->push);
    }
    return count;
  };
  std::size_t index = 0;
  for (;; ++index) {
    const auto one = vectors::make_set(set->unit(), set->parameters(), set->seed());
    one->copy_case(*set, index);
    if (pushes(*one) >= 3) break;
  }
  const auto smaller = minimise(*set, index, [&](const vectors::VectorSet& one) { return pushes(one) >= 3; });
  EXPECT_EQ(smaller->stimulus_count(), 3u);
  EXPECT_EQ(smaller->response_count(), 3u) << "the golden answers the shorter episode anew";
}

TEST(Minimise, leaves_trees_whole_that_fail_together_only) {
  const auto set = vectors::generate_set("stream_compressor", {6, 2}, 23 * 4, 3);
  const auto trees = [](const vectors::VectorSet& one) {
    int count = 0;
    for (std::size_t i = 0; i < one.stimulus_count(); ++i) {
      count += bool(static_cast<const rtl::StreamJob*>(one.stimulus_at(i))->root);
    }
    return count;
  };
  std::size_t tried = 0;
  for (std::size_t index = 0; index < set->size(); ++index) {
    if (set->class_name(index) != "small-trees") continue;
    const auto smaller = minimise(*set, index, [&](const vectors::VectorSet& one) { return trees(one) >= 2; });
    EXPECT_EQ(trees(*smaller), 2);
    ++tried;
  }
  EXPECT_EQ(tried, 4U);
}

TEST(Subtrees, are_of_one_tree_and_of_several_behind_each_other_there_are_none) {
  const auto set = vectors::generate_set("stream_compressor", {6, 2}, 23 * 4, 3);
  int alone = 0;
  int several = 0;
  for (std::size_t index = 0; index < set->size(); ++index) {
    const auto range = set->stimulus_range(index);
    std::vector<std::vector<std::uint8_t>> stream;
    int trees = 0;
    for (std::size_t i = range.begin; i < range.begin + range.size; ++i) {
      const auto* const job = static_cast<const rtl::StreamJob*>(set->stimulus_at(i));
      trees += bool(job->root);
      const auto* const bytes = reinterpret_cast<const std::uint8_t*>(job);
      stream.emplace_back(bytes, bytes + sizeof(*job));
    }
    if (set->class_name(index) == "small-trees" || set->class_name(index) == "two-trees") {
      ASSERT_GE(trees, 2);
      EXPECT_TRUE(subtrees(stream).empty()) << "case " << index;
      ++several;
    } else if (set->class_name(index) == "balanced") {
      EXPECT_EQ(subtrees(stream).size(), stream.size() - 1) << "case " << index;
      ++alone;
    }
  }
  EXPECT_EQ(several, 8);
  EXPECT_EQ(alone, 4);
}

/// Stops taking jobs after the third.
class HangingUnit {
 public:
  HangingUnit(rtl::Channel<AxisJob>& jobs, rtl::Channel<Result>& results) : jobs_(jobs), results_(results) {}
  void tick() {
    if (taken_ == 3 || !jobs_.can_pop() || !results_.can_push()) return;
    jobs_.pop();
    ++taken_;
    results_.push({});
  }
  void commit(rtl::CommitKey) {}

 private:
  rtl::Channel<AxisJob>& jobs_;
  rtl::Channel<Result>& results_;
  int taken_ = 0;
};

TEST(InOutBench, gives_a_hanging_unit_up_and_says_so) {
  const auto set = vectors::generate_set("axis_compressor", {}, 8, 3);
  RunOptions options;
  options.hang_cycles = 100;
  const Responses responses = stream_cases<AxisJob, Result>(
      [](auto& jobs, auto& results) { return HangingUnit(jobs, results); }, *set, options);
  ASSERT_EQ(responses.cases(), 8u);
  EXPECT_FALSE(responses.at_case(2).hung);
  EXPECT_TRUE(responses.at_case(3).hung);
  EXPECT_EQ(responses.at_case(3).size, 0u);
  EXPECT_LT(responses.cycles, 400u);
}

}  // namespace
}  // namespace cbvh::testbench
