// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/report/json.h"

#include "golden/input_error.h"

namespace cbvh::testbench {

namespace {

constexpr int kFormat = 1;

Json mismatch_to_json(const Mismatch& mismatch) {
  return {{"unit", mismatch.unit},        {"set", mismatch.set},           {"id", mismatch.id},
          {"class", mismatch.case_class}, {"response", mismatch.response}, {"field", mismatch.field},
          {"found", mismatch.found},      {"wanted", mismatch.wanted},     {"rerun", mismatch.rerun},
          {"minimal", mismatch.minimal}};
}

Mismatch mismatch_from_json(const Json& json) {
  return {json.at("unit"),  json.at("set"),   json.at("id"),     json.at("class"), json.at("response"),
          json.at("field"), json.at("found"), json.at("wanted"), json.at("rerun"), json.at("minimal")};
}

Json set_to_json(const SetReport& set) {
  Json mismatches = Json::array();
  for (const Mismatch& mismatch : set.mismatches) mismatches.push_back(mismatch_to_json(mismatch));
  return {{"unit", set.unit},
          {"set", set.set},
          {"backend", set.backend},
          {"mode", set.mode},
          {"total_cases", set.total_cases},
          {"cases", set.cases},
          {"checks", set.checks},
          {"failures", set.failures},
          {"cycles", set.cycles},
          {"seconds", set.seconds},
          {"classes", set.classes},
          {"mismatches", mismatches}};
}

SetReport set_from_json(const Json& json) {
  SetReport set;
  set.unit = json.at("unit");
  set.set = json.at("set");
  set.backend = json.at("backend");
  set.mode = json.at("mode");
  set.total_cases = json.at("total_cases");
  set.cases = json.at("cases");
  set.checks = json.at("checks");
  set.failures = json.at("failures");
  set.cycles = json.at("cycles");
  set.seconds = json.at("seconds");
  set.classes = json.at("classes").get<Bins>();
  for (const Json& mismatch : json.at("mismatches")) set.mismatches.push_back(mismatch_from_json(mismatch));
  return set;
}

}  // namespace

Json to_json(const Report& report) {
  const Verdict verdict = judge(report);
  Json sets = Json::array();
  for (const SetReport& set : report.sets) sets.push_back(set_to_json(set));
  return {{"cbvh_report", kFormat},
          {"command", report.command},
          {"suite", report.suite},
          {"seed", report.seed},
          {"shard", to_string(report.shard)},
          {"bins_must_be_hit", report.bins_must_be_hit},
          {"passed", verdict.passed},
          {"failed", verdict.failed},
          {"empty_bins", verdict.empty_bins},
          {"empty_sets", verdict.empty_sets},
          {"corners", report.corners},
          {"sets", sets}};
}

Report report_from_json(const std::string& text, const std::string& place) {
  try {
    const Json json = Json::parse(text);
    if (json.at("cbvh_report") != kFormat) {
      throw golden::InputError(place,
                               fmt::format("found report format {}, want {}", json.at("cbvh_report").dump(), kFormat));
    }
    Report report;
    report.command = json.at("command");
    report.suite = json.at("suite");
    report.seed = json.at("seed");
    report.shard = parse_shard(json.at("shard"));
    report.bins_must_be_hit = json.at("bins_must_be_hit");
    report.corners = json.at("corners").get<Bins>();
    for (const Json& set : json.at("sets")) report.sets.push_back(set_from_json(set));
    return report;
  } catch (const nlohmann::json::exception& error) {
    throw golden::InputError(place, fmt::format("not a report of cbvh: {}", error.what()));
  }
}

}  // namespace cbvh::testbench
