// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "golden/input_error.h"
#include "testbench/report/json.h"
#include "testbench/report/junit.h"
#include "testbench/report/merge.h"
#include "testbench/report/print.h"

namespace cbvh::testbench {
namespace {

using golden::InputError;

/// A run of 10 cases of 3 checks each in one set; the shard has its share of it.
Report sample_run(const Shard& shard) {
  Report report;
  report.command = "regress";
  report.suite = "smoke";
  report.seed = 7;
  report.shard = shard;
  SetReport set;
  set.unit = "axis_compressor";
  set.set = "generated bits=6";
  set.backend = "rtl";
  set.mode = "none";
  set.total_cases = 10;
  set.classes = {{"even", 0}, {"odd", 0}};
  report.corners = {{"axis_full_grid", 0}};
  for (std::uint64_t id = 0; id < 10; ++id) {
    if (!owns(shard, id)) continue;
    ++set.cases;
    set.checks += 3;
    set.cycles += 5;
    ++set.classes[id % 2 == 0 ? "even" : "odd"];
    report.corners["axis_full_grid"] += id;
    if (id % 4 != 3) continue;
    ++set.failures;
    set.mismatches.push_back({set.unit, set.set, id, "odd", 0, "code_lo", "01", "02", "cbvh ...", ""});
  }
  report.sets = {set};
  return report;
}

std::string error_of(const std::vector<NamedReport>& parts) {
  try {
    merge(parts);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(Report, corners_that_no_backend_observes_are_not_said_to_be_missed) {
  Report report = sample_run({});
  report.corners["axis_full_grid"] = 0;
  EXPECT_NE(to_string(report).find("warning: corner axis_full_grid was never hit"), std::string::npos);
  report.corners.clear();
  report.sets.push_back(report.sets[0]);
  report.sets[1].backend = "board";
  const std::string text = to_string(report);
  EXPECT_NE(text.find("corners of the model: not observed by board, rtl\n"), std::string::npos);
  EXPECT_EQ(text.find("corner axis_full_grid"), std::string::npos);
}

TEST(Report, counts_every_check_once) {
  const Verdict verdict = judge(sample_run({}));
  EXPECT_EQ(verdict.passed, 28u);
  EXPECT_EQ(verdict.failed, 2u);
  EXPECT_FALSE(verdict.pass());
}

TEST(Report, closes_with_the_totals_alone_on_the_last_line) {
  const std::string text = to_string(sample_run({}));
  EXPECT_TRUE(text.ends_with("\n28 passed, 2 failed\n")) << text;
}

TEST(Report, zero_checks_fail_with_a_message_of_their_own) {
  Report report;
  EXPECT_FALSE(judge(report).pass());
  EXPECT_NE(to_string(report).find("zero checks: nothing was compared"), std::string::npos);
  report = sample_run({});
  report.sets[0].checks = report.sets[0].failures = 0;
  report.sets[0].mismatches.clear();
  EXPECT_EQ(judge(report).failed, 1u);
  EXPECT_NE(to_string(report).find("FAILED: axis_compressor generated bits=6 none: zero checks"), std::string::npos);
}

TEST(Report, an_empty_bin_fails_only_where_bins_must_be_hit) {
  Report report = sample_run({});
  report.corners["stack_overflow"] = 0;
  EXPECT_EQ(judge(report).failed, 2u);
  report.bins_must_be_hit = true;
  EXPECT_EQ(judge(report).failed, 3u);
  EXPECT_EQ(judge(report).empty_bins, std::vector<std::string>{"corner stack_overflow"});
  report.shard = {0, 2};
  EXPECT_EQ(judge(report).failed, 2u) << "a shard need not hit them all";
}

TEST(Report, survives_json_unchanged) {
  const Report report = sample_run({1, 3});
  const std::string text = to_json(report).dump();
  EXPECT_EQ(to_json(report_from_json(text, "a.json")).dump(), text);
  EXPECT_THROW(report_from_json("{}", "a.json"), InputError);
  EXPECT_THROW(report_from_json("[1", "a.json"), InputError);
  EXPECT_THROW(report_from_json("{\"cbvh_report\": 99}", "a.json"), InputError);
}

TEST(Merge, of_all_shards_equals_one_run) {
  for (const std::uint64_t count : {1u, 2u, 3u, 7u, 12u}) {
    std::vector<NamedReport> parts;
    for (std::uint64_t i = count; i-- > 0;) parts.push_back({std::to_string(i), sample_run({i, count})});
    EXPECT_EQ(to_json(merge(parts)).dump(), to_json(sample_run({})).dump()) << count << " shards";
  }
}

TEST(Merge, of_runs_of_different_sets_holds_them_all) {
  Report other = sample_run({});
  other.sets[0].mode = "source";
  const Report both = merge({{"a", sample_run({})}, {"b", other}});
  EXPECT_EQ(both.sets.size(), 2u);
  EXPECT_EQ(judge(both).passed, 56u);
}

TEST(Merge, rejects_missing_duplicate_and_inconsistent_shards) {
  const NamedReport first{"a.json", sample_run({0, 2})};
  const NamedReport second{"b.json", sample_run({1, 2})};
  EXPECT_EQ(error_of({first, second}), "no error");
  EXPECT_NE(error_of({first}).find("shard 1/2 is missing"), std::string::npos);
  EXPECT_NE(error_of({first, second, first}).find("shard 0/2 is already in a.json"), std::string::npos);
  NamedReport odd = second;
  odd.report.seed = 8;
  EXPECT_NE(error_of({first, odd}).find("b.json: seed: found '8', want '7'"), std::string::npos);
  odd = second;
  odd.report.sets[0].total_cases = 11;
  EXPECT_NE(error_of({first, odd}).find("total_cases: found '11', want '10'"), std::string::npos);
  odd = second;
  odd.report.sets[0].cases = 4;
  EXPECT_NE(error_of({first, odd}).find("the shards have 9 cases, want 10"), std::string::npos);
  odd = {"b.json", sample_run({1, 3})};
  EXPECT_NE(error_of({first, odd}).find("shard count: found '3', want '2'"), std::string::npos);
  EXPECT_NE(error_of({}).find("no reports"), std::string::npos);
}

TEST(Junit, escapes_what_xml_cannot_hold) {
  EXPECT_EQ(xml_escape("a<b>&\"'\n\x01"), "a&lt;b&gt;&amp;&quot;&apos;&#10;?");
  Report report = sample_run({});
  report.sets[0].set = "<scene & co>";
  const std::string xml = to_junit(report);
  EXPECT_EQ(xml.find("<scene"), std::string::npos);
  EXPECT_NE(xml.find("name=\"&lt;scene &amp; co&gt; [none]\""), std::string::npos);
}

TEST(Junit, has_a_test_case_for_each_set_and_for_coverage) {
  const std::string xml = to_junit(sample_run({}));
  EXPECT_NE(xml.find("tests=\"2\" failures=\"1\""), std::string::npos) << xml;
  EXPECT_NE(xml.find("<failure message=\"2 of 30 checks failed\">"), std::string::npos);
}

TEST(Shard, shares_are_disjoint_and_cover_all) {
  for (std::uint64_t number = 0; number < 30; ++number) {
    int owners = 0;
    for (std::uint64_t index = 0; index < 4; ++index) owners += owns(Shard{index, 4}, number);
    EXPECT_EQ(owners, 1);
  }
  EXPECT_EQ(to_string(parse_shard("1/4")), "1/4");
  EXPECT_EQ(to_string(parse_shard("4/4")), "0/4") << "counting from 1 works too";
  for (const char* bad : {"", "1", "/", "1/", "/2", "5/4", "1/0", "-1/4", "1/4x", "a/b", "1 /4"}) {
    EXPECT_THROW(parse_shard(bad), InputError) << bad;
  }
}

}  // namespace
}  // namespace cbvh::testbench
