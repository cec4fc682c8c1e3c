// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/regression/regress.h"

#include <gtest/gtest.h>

#include <atomic>

#include "golden/input_error.h"
#include "golden/threads/parallel_for.h"
#include "testbench/report/json.h"
#include "testbench/report/merge.h"

namespace cbvh::testbench {
namespace {

/// Everything but the time it took.
std::string counted(Report report) {
  for (SetReport& set : report.sets) set.seconds = 0;
  return to_json(report).dump(1);
}

/// Pieces cut the stream differently in every shard, so simulated cycles may differ; what is checked may not.
std::string checked(Report report) {
  for (SetReport& set : report.sets) set.cycles = 0;
  return counted(report);
}

RegressionOptions small_run() {
  RegressionOptions options;
  options.units = {"axis_compressor", "context_stack"};
  options.threads = 1;
  return options;
}

TEST(Regress, has_the_same_report_on_any_number_of_threads) {
  RegressionOptions options = small_run();
  const std::string alone = counted(regress(options));
  for (const unsigned threads : {2u, 4u}) {
    options.threads = threads;
    EXPECT_EQ(counted(regress(options)), alone) << threads << " threads";
  }
}

TEST(Regress, shards_add_up_to_one_run) {
  RegressionOptions options = small_run();
  const std::string whole = checked(regress(options));
  for (const std::uint64_t count : {2u, 3u}) {
    std::vector<NamedReport> parts;
    for (std::uint64_t index = 0; index < count; ++index) {
      options.shard = {index, count};
      parts.push_back({std::to_string(index), regress(options)});
    }
    EXPECT_EQ(checked(merge(parts)), whole) << count << " shards";
  }
}

TEST(Regress, passes_and_checks_something) {
  const Verdict verdict = judge(regress(small_run()));
  EXPECT_EQ(verdict.failed, 0u);
  EXPECT_GT(verdict.passed, 100000u);
}

TEST(Regress, names_what_it_does_not_know) {
  const auto error_of = [](auto change) -> std::string {
    RegressionOptions options;
    change(options);
    try {
      make_plan(options);
    } catch (const golden::InputError& error) {
      return error.what();
    }
    return "no error";
  };
  EXPECT_NE(error_of([](auto& o) { o.suite = "smoky"; }).find("'smoky', known: smoke, full"), std::string::npos);
  EXPECT_NE(error_of([](auto& o) { o.units = {"axis"}; }).find("axis_compressor"), std::string::npos);
  EXPECT_NE(error_of([](auto& o) { o.backends = {"fpga"}; }).find("known: board, gateware, golden, rtl"),
            std::string::npos);
  EXPECT_NE(error_of([](auto& o) { o.stalls = {"some"}; }).find("known: none, source, sink, both"), std::string::npos);
  EXPECT_NE(error_of([](auto& o) { o.set = "x"; }).find("nothing to run"), std::string::npos);
}

TEST(ParallelFor, calls_every_piece_once_and_rethrows) {
  std::vector<std::atomic<int>> calls(1000);
  golden::parallel_for(calls.size(), 4, [&](std::size_t i) { ++calls[i]; });
  for (const auto& count : calls) EXPECT_EQ(count, 1);
  EXPECT_THROW(golden::parallel_for(10, 3,
                                    [](std::size_t i) {
                                      if (i == 5) throw golden::InputError("five", "bad");
                                    }),
               golden::InputError);
}

}  // namespace
}  // namespace cbvh::testbench
