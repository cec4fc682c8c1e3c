// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/eval/findings.h"

#include <gtest/gtest.h>

#include "testbench/exit_code.h"

namespace cbvh::testbench {
namespace {

struct Measured {
  std::uint64_t checks;
  std::vector<std::string> failures;
};

TEST(Findings, pass_when_something_was_checked_and_nothing_was_wrong) {
  Findings findings;
  EXPECT_EQ(report(findings, Output()), kMismatch) << "zero checks";
  findings.add_all(std::vector<Measured>{{2, {}}, {3, {}}});
  EXPECT_EQ(findings.checks, 5U);
  EXPECT_EQ(report(findings, Output()), kPass);
  findings.add(Measured{1, {"a bit"}});
  EXPECT_EQ(findings.checks, 6U);
  EXPECT_EQ(findings.failures, std::vector<std::string>{"a bit"});
  EXPECT_EQ(report(findings, Output()), kMismatch) << "a failure";
}

TEST(Findings, write_every_table_for_programs_and_those_for_people_as_text) {
  Findings findings{1, {"a bit"}, {}};
  for (const bool in_text : {true, false}) {
    Table table{in_text ? "seen" : "unseen", in_text ? "Seen" : "Unseen", {{"name", "name"}}, 1, {{"x"}}, {}, in_text};
    findings.tables.push_back(table);
  }
  ::testing::internal::CaptureStdout();
  report(findings, Output(), "# Heading\n");
  const std::string text = ::testing::internal::GetCapturedStdout();
  EXPECT_EQ(text.find("# Heading\n"), 0U);
  EXPECT_NE(text.find("Seen"), text.npos);
  EXPECT_EQ(text.find("Unseen"), text.npos);
  EXPECT_NE(text.find("FAILED: a bit\n0 checks passed, 1 failed\n"), text.npos);
}

}  // namespace
}  // namespace cbvh::testbench
