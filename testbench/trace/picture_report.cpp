// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/trace/picture_report.h"

#include <fmt/format.h>

#include "testbench/trace/colours.h"

namespace cbvh::testbench {

namespace {

Json to_json(const golden::RayCounts& counts) {
  return {{"rays", counts.rays},
          {"pairs", counts.tests.pairs},
          {"box_tests", counts.tests.box_tests},
          {"triangle_tests", counts.tests.triangle_tests}};
}

Json to_json(const TreeCost& tree) {
  return {{"tree", tree.name},
          {"primary", to_json(tree.primary)},
          {"secondary", to_json(tree.secondary)},
          {"seconds", tree.seconds},
          {"rays_per_second", tree.rays_per_second()},
          {"different_pixels", tree.different_pixels}};
}

/// Null where nothing was tested.
Json ratio(std::uint64_t of, std::uint64_t to) {
  return to == 0 ? Json() : Json(static_cast<double>(of) / static_cast<double>(to));
}

Json ratios(const golden::RayCounts& compressed, const golden::RayCounts& floats) {
  return {{"box_tests", ratio(compressed.tests.box_tests, floats.tests.box_tests)},
          {"triangle_tests", ratio(compressed.tests.triangle_tests, floats.tests.triangle_tests)}};
}

std::string row(const Json& json, const char* rays) {
  const Json& floats = json.at("float").at(rays);
  const Json& compressed = json.at("compressed").at(rays);
  if (floats.at("rays") == 0) return "";
  std::string text = fmt::format("{:<10} {:>10}", rays, floats.at("rays").get<std::uint64_t>());
  for (const char* tests : {"box_tests", "triangle_tests"}) {
    const Json& times = json.at("ratio").at(rays).at(tests);
    text += fmt::format(" {:>14} {:>14} {:>7}", floats.at(tests).get<std::uint64_t>(),
                        compressed.at(tests).get<std::uint64_t>(),
                        times.is_null() ? "-" : fmt::format("{:.4f}", times.get<double>()));
  }
  return text + '\n';
}

}  // namespace

TracedScenes::TracedScenes(const TraceTrees& of, bool all) : job(of) {
  add(job, true);
  for (std::size_t i = 0; all && i < kCompressions.size(); ++i) {
    TraceTrees other = job;
    other.compression = static_cast<Compression>(i);
    const bool refits = other.compression == Compression::refitted;
    if (other.compression == job.compression || (refits && names_instances(job.scene))) continue;
    add(other, refits);
  }
}

void TracedScenes::add(const TraceTrees& of, bool with_floats) {
  scenes_.push_back(load_traced_scene(of));
  const TracedScene& scene = *scenes_.back();
  const std::string name(kCompressions[static_cast<std::size_t>(of.compression)]);
  const auto through = [&scene](bool compressed) {
    return [&scene, compressed](const Shot& shot) { return scene.pixels(compressed, shot); };
  };
  if (with_floats) trees.push_back({trees.empty() ? "float" : "float " + name, through(false)});
  trees.push_back({name, through(true)});
  ++checks;
  if (!scene.identical()) failures.push_back(fmt::format("the {} tree is not the golden's top-down one", name));
}

Json to_json(const TracedScenes& scenes, const PictureJob& job, const TracedPicture& picture) {
  const TreeCost& floats = picture.trees[0];
  const TreeCost& compressed = picture.trees[1];
  Json trees = Json::array();
  for (const TreeCost& tree : picture.trees) trees.push_back(to_json(tree));
  std::vector<std::string> failures = scenes.failures;
  if (picture.different_pixels > 0) failures.push_back(picture.first_difference);
  return {{"scene", scenes.job.scene},
          {"builder", scenes.job.builder},
          {"compression", kCompressions[static_cast<std::size_t>(scenes.job.compression)]},
          {"code", scenes.job.code == golden::Code::modulo ? "modulo" : "relative"},
          {"bits", scenes.job.bits},
          {"triangles", scenes.first().triangles()},
          {"width", job.width},
          {"height", job.height},
          {"camera", job.camera},
          {"rays", kRayKinds[static_cast<std::size_t>(job.rays)]},
          {"samples", job.samples},
          {"hits", picture.hits},
          {"float", to_json(floats)},
          {"compressed", to_json(compressed)},
          {"ratio",
           {{"primary", ratios(compressed.primary, floats.primary)},
            {"secondary", ratios(compressed.secondary, floats.secondary)}}},
          {"speed_ratio", compressed.rays_per_second() / floats.rays_per_second()},
          {"most_box_tests", most_tests(picture, ImageKind::box_tests)},
          {"most_triangle_tests", most_tests(picture, ImageKind::triangle_tests)},
          {"trees", trees},
          {"tree_checks", scenes.checks},
          {"different_trees", scenes.failures.size()},
          {"different_pixels", picture.different_pixels},
          {"failures", failures},
          {"pass", failures.empty()}};
}

std::string to_text(const Json& json) {
  std::string text = fmt::format("{}: {} triangles, {} x {} pixels, {} of them hit; built by {}, N = {}, {} codes\n",
                                 json.at("scene").get<std::string>(), json.at("triangles").get<std::uint64_t>(),
                                 json.at("width").get<unsigned>(), json.at("height").get<unsigned>(),
                                 json.at("hits").get<std::uint64_t>(), json.at("builder").get<std::string>(),
                                 json.at("bits").get<int>(), json.at("code").get<std::string>());
  text += fmt::format("{:<10} {:>10} {:>14} {:>14} {:>7} {:>14} {:>14} {:>7}\n", "rays", "count", "box tests",
                      "compressed", "ratio", "triangle tests", "compressed", "ratio");
  text += row(json, "primary") + row(json, "secondary");
  text += fmt::format("most tests of a pixel: {} boxes, {} triangles\n", json.at("most_box_tests").get<std::uint32_t>(),
                      json.at("most_triangle_tests").get<std::uint32_t>());
  for (const Json& tree : json.at("trees")) {
    text += fmt::format("{:<16} {:>10.0f} rays a second and thread, {} pixels differ from the first tree's\n",
                        tree.at("tree").get<std::string>(), tree.at("rays_per_second").get<double>(),
                        tree.at("different_pixels").get<std::uint64_t>());
  }
  for (const Json& failure : json.at("failures")) text += fmt::format("FAILED: {}\n", failure.get<std::string>());
  const std::uint64_t pixels = json.at("width").get<std::uint64_t>() * json.at("height").get<std::uint64_t>();
  const auto different = json.at("different_pixels").get<std::uint64_t>();
  return text + fmt::format("{} pixels the same through all {} trees, {} not\n", pixels - different,
                            json.at("trees").size(), different);
}

}  // namespace cbvh::testbench
