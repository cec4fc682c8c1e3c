// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/eval/rays/tables.h"

#include <algorithm>

#include "testbench/trace/picture_report.h"

namespace cbvh::testbench {

namespace {

/// Tests through a compressed tree over those through the float tree, as papers have them.
struct PaperRatios {
  int bits;
  const char* box;
  const char* triangle;
};
constexpr std::array<PaperRatios, 2> kPaperRatios = {{
    {6, "1.08", "1.13"},             // this paper, section 5.5: the averages over its scenes
    {8, "1.04-1.055", "1.16-1.18"},  // AQB8, from its published code
}};

const PaperRatios* paper_ratios(int bits) {
  const auto* const found = std::find_if(kPaperRatios.begin(), kPaperRatios.end(),
                                         [&](const PaperRatios& ratios) { return ratios.bits == bits; });
  return found == kPaperRatios.end() ? nullptr : found;
}

Json per_ray(std::uint64_t tests, const golden::RayCounts& counts) {
  return counts.rays == 0 ? Json() : Json(static_cast<double>(tests) / static_cast<double>(counts.rays));
}

Json ratio(std::uint64_t of, std::uint64_t to) {
  return to == 0 ? Json() : Json(static_cast<double>(of) / static_cast<double>(to));
}

/// Mean, least and most of the ratios there are; nulls without any.
std::vector<Json> mean_and_range(const std::vector<double>& ratios) {
  if (ratios.empty()) return {Json(), Json(), Json()};
  double sum = 0;
  for (const double one : ratios) sum += one;
  const auto [least, most] = std::minmax_element(ratios.begin(), ratios.end());
  return {sum / static_cast<double>(ratios.size()), *least, *most};
}

std::vector<Json> average_row(const std::vector<RaysMeasure>& measures, const std::string& rays, std::size_t which) {
  std::vector<double> box;
  std::vector<double> triangle;
  for (const RaysMeasure& m : measures) {
    if (rays != "all" && rays != m.rays) continue;
    const Json boxes = ratio(m.compressed[which].tests.box_tests, m.floats.tests.box_tests);
    const Json triangles = ratio(m.compressed[which].tests.triangle_tests, m.floats.tests.triangle_tests);
    if (boxes.is_number()) box.push_back(boxes);
    if (triangles.is_number()) triangle.push_back(triangles);
  }
  const PaperRatios* const paper = paper_ratios(kTracedBits[which]);
  std::vector<Json> row = {rays, kTracedBits[which]};
  for (const Json& cell : mean_and_range(box)) row.push_back(cell);
  row.push_back(paper == nullptr ? Json() : Json(paper->box));
  for (const Json& cell : mean_and_range(triangle)) row.push_back(cell);
  row.push_back(paper == nullptr ? Json() : Json(paper->triangle));
  return row;
}

}  // namespace

Table ray_tests_table(const std::vector<RaysMeasure>& measures) {
  Table table{"ray_tests",
              "Rays: tests through compressed trees",
              {{"scene", "scene"},
               {"rays", "rays"},
               {"bits", "N"},
               {"count", "count"},
               {"float_box_tests", "box tests a ray, float", 2},
               {"box_ratio", "compressed / float", 4},
               {"float_triangle_tests", "triangle tests a ray, float", 2},
               {"triangle_ratio", "compressed / float", 4}},
              3,
              {},
              {"secondary rays are counted without the primary ones before them"},
              true};
  for (const RaysMeasure& m : measures) {
    for (std::size_t i = 0; i < kTracedBits.size(); ++i) {
      table.rows.push_back({m.scene, m.rays, kTracedBits[i], m.floats.rays, per_ray(m.floats.tests.box_tests, m.floats),
                            ratio(m.compressed[i].tests.box_tests, m.floats.tests.box_tests),
                            per_ray(m.floats.tests.triangle_tests, m.floats),
                            ratio(m.compressed[i].tests.triangle_tests, m.floats.tests.triangle_tests)});
    }
  }
  return table;
}

Table ray_tests_average_table(const std::vector<RaysMeasure>& measures) {
  Table table{
      "ray_tests_average",
      "Rays: the averages over all scenes",
      {{"rays", "rays"},
       {"bits", "N"},
       {"box_ratio", "box tests, compressed / float", 4},
       {"box_ratio_least", "least", 4},
       {"box_ratio_most", "most", 4},
       {"paper_box_ratio", "papers"},
       {"triangle_ratio", "triangle tests, compressed / float", 4},
       {"triangle_ratio_least", "least", 4},
       {"triangle_ratio_most", "most", 4},
       {"paper_triangle_ratio", "papers"}},
      2,
      {},
      {"papers: N = 6 is the paper's average over its scenes (section 5.5), N = 8 what AQB8's published code gives",
       "a mean of ratios; all: of every scene and kind of rays"},
      true};
  std::vector<std::string> kinds = {"all"};
  for (const std::string_view kind : kRayKinds) kinds.emplace_back(kind);
  for (const std::string& kind : kinds) {
    for (std::size_t i = 0; i < kTracedBits.size(); ++i) table.rows.push_back(average_row(measures, kind, i));
  }
  return table;
}

}  // namespace cbvh::testbench
