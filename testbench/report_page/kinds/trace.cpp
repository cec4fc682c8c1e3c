// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "testbench/report_page/bars.h"
#include "testbench/report_page/result.h"
#include "testbench/report_page/scale.h"
#include "testbench/report_page/table.h"

/// `cbvh trace`: one picture through the float tree and the compressed one, and their tests.
namespace cbvh::testbench {

namespace {

constexpr int kPaperBits = 6;  ///< N of the paper's averages
constexpr std::array<const char*, 2> kRays = {"primary", "secondary"};

struct Tests {
  const char* key;
  const char* name;
  double paper;  ///< compressed over float, the paper's average
};
constexpr std::array<Tests, 2> kTests = {
    {{"box_tests", "box tests", 1.08}, {"triangle_tests", "triangle tests", 1.13}}};

/// Every pixel is a check: it must see the same through all trees. So is every compressed tree: it must be the
/// golden's.
Tally tally(const Json& json) {
  const std::uint64_t checks = count(json, "width") * count(json, "height") + count(json, "tree_checks");
  const std::uint64_t failed = count(json, "different_pixels") + count(json, "different_trees");
  return {checks - std::min(checks, failed), failed, 0};
}

std::vector<std::string> row(const Json& json, const char* rays) {
  const Json& floats = json.at("float").at(rays);
  const Json& compressed = json.at("compressed").at(rays);
  std::vector<std::string> cells = {rays, count_text(count(floats, "rays"))};
  for (const Tests& tests : kTests) {
    cells.push_back(count_text(count(floats, tests.key)));
    cells.push_back(count_text(count(compressed, tests.key)));
    cells.push_back(cell_text(json.at("ratio").at(rays).at(tests.key), 4));
  }
  return cells;
}

Markup show(const Json& json, Figures& figures) {
  const int bits = json.at("bits");
  BarChart chart{"Tests through the compressed tree",
                 "tests over those through the float tree",
                 {"this picture"},
                 {},
                 bits == kPaperBits ? "the paper's average" : ""};
  std::vector<std::vector<std::string>> rows;
  for (const char* const rays : kRays) {
    if (count(json.at("float").at(rays), "rays") == 0) continue;
    rows.push_back(row(json, rays));
    for (const Tests& tests : kTests) {
      const Json& ratio = json.at("ratio").at(rays).at(tests.key);
      if (ratio.is_null()) continue;
      Bar bar{fmt::format("{} rays", rays), tests.name, {ratio.get<double>()}};
      if (bits == kPaperBits) bar.reference = tests.paper;
      chart.bars.push_back(bar);
    }
  }
  Markup markup =
      element("h3", fmt::format("{}, built by {}, N = {}, {} codes, {}, {} rays", json.at("scene").get<std::string>(),
                                json.at("builder").get<std::string>(), bits, json.at("code").get<std::string>(),
                                json.at("compression").get<std::string>(), json.at("rays").get<std::string>()));
  markup += plain_table(
      "Tests",
      {"rays", "count", "box tests, float", "compressed", "ratio", "triangle tests, float", "compressed", "ratio"},
      rows);
  markup += element("p", fmt::format("{} rays a second through the float tree, {} through the compressed one.",
                                     tick_text(json.at("float").at("rays_per_second").get<double>()),
                                     tick_text(json.at("compressed").at("rays_per_second").get<double>())));
  markup += draw(chart, figures);
  return markup;
}

}  // namespace

ResultKind trace_kind() {
  return {"traced picture",
          "cbvh trace --json",
          {"scene", "float", "compressed", "different_pixels"},
          Chapter::rays,
          tally,
          show};
}

}  // namespace cbvh::testbench
