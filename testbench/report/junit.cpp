// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/report/junit.h"

#include <fmt/format.h>

#include "testbench/report/print.h"

namespace cbvh::testbench {

namespace {

std::string failure(const std::string& message, const std::string& text) {
  return fmt::format("    <failure message=\"{}\">{}</failure>\n", xml_escape(message), xml_escape(text));
}

std::string test_case(const std::string& suite, const std::string& name, double seconds, const std::string& body) {
  return fmt::format("  <testcase classname=\"{}\" name=\"{}\" time=\"{:.3f}\">\n{}  </testcase>\n", xml_escape(suite),
                     xml_escape(name), seconds, body);
}

std::string set_body(const SetReport& set, bool whole) {
  if (set.failures != 0) {
    std::string text;
    for (const Mismatch& mismatch : set.mismatches) text += to_string(mismatch) + '\n';
    return failure(fmt::format("{} of {} checks failed", set.failures, set.checks), text);
  }
  return set.checks == 0 && (whole || set.cases != 0) ? failure("zero checks", "") : "";
}

}  // namespace

std::string xml_escape(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      case '\'':
        escaped += "&apos;";
        break;
      case '\n':
        escaped += "&#10;";
        break;
      case '\t':
        escaped += "&#9;";
        break;
      default:
        escaped += static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? '?' : c;
    }
  }
  return escaped;
}

std::string to_junit(const Report& report) {
  const Verdict verdict = judge(report);
  std::string cases;
  double seconds = 0;
  std::size_t tests = 0;
  std::size_t failed = 0;
  const auto add = [&](const std::string& suite, const std::string& name, double time, const std::string& body) {
    cases += test_case(suite, name, time, body);
    seconds += time;
    ++tests;
    failed += body.empty() ? 0 : 1;
  };
  for (const SetReport& set : report.sets) {
    const std::string suite = fmt::format("cbvh.{}.{}", set.backend, set.unit);
    add(suite, fmt::format("{} [{}]", set.set, set.mode), set.seconds, set_body(set, is_whole(report.shard)));
  }
  std::string empty;
  for (const std::string& bin : verdict.empty_bins) empty += bin + '\n';
  if (!report.bins_must_be_hit) empty.clear();
  add("cbvh.coverage", "every class and corner is hit", 0, empty.empty() ? "" : failure("empty bins", empty));
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<testsuite name=\"cbvh {} {}\" tests=\"{}\" failures=\"{}\" errors=\"0\" skipped=\"0\" time=\"{:.3f}\">\n"
      "  <properties>\n    <property name=\"seed\" value=\"{}\"/>\n    <property name=\"shard\" value=\"{}\"/>\n"
      "    <property name=\"passed\" value=\"{}\"/>\n    <property name=\"failed\" value=\"{}\"/>\n  </properties>\n"
      "{}</testsuite>\n",
      xml_escape(report.command), xml_escape(report.suite), tests, failed, seconds, report.seed,
      to_string(report.shard), verdict.passed, verdict.failed, cases);
}

}  // namespace cbvh::testbench
