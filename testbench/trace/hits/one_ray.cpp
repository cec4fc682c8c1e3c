// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/trace/hits/one_ray.h"

#include <fmt/format.h>

#include "golden/input_error.h"
#include "golden/scene/load.h"
#include "golden/trace/compressed_view.h"
#include "testbench/trace/compression.h"
#include "testbench/trace/hits/compare_hit.h"
#include "testbench/unavailable.h"

namespace cbvh::testbench {

namespace {

Json hit_json(std::uint32_t primitive, double t) {
  if (primitive == golden::Hit::kNone) return {{"hits", false}};
  return {{"hits", true}, {"triangle", primitive}, {"t", t}};
}

template <class View>
Json through(const View& view, const golden::Mesh& mesh, const golden::Ray& ray, golden::Hit& hit) {
  golden::Tracer tracer{view, mesh};
  hit = tracer.trace(ray, golden::Stop::closest);
  Json json = hit_json(hit.primitive, hit.t);
  json["pairs"] = tracer.counts().pairs;
  json["box_tests"] = tracer.counts().box_tests;
  json["triangle_tests"] = tracer.counts().triangle_tests;
  return json;
}

}  // namespace

golden::Ray parse_ray(const std::string& place, const std::string& text) {
  std::vector<float> numbers;
  for (std::size_t start = 0; start <= text.size();) {
    const std::size_t end = std::min(text.find(',', start), text.size());
    std::size_t used = 0;
    const std::string number = text.substr(start, end - start);
    try {
      numbers.push_back(std::stof(number, &used));
    } catch (const std::exception&) {
      used = std::string::npos;
    }
    if (used != number.size()) throw golden::InputError(place, fmt::format("found '{}', want a number", number));
    start = end + 1;
  }
  if (numbers.size() != 6 && numbers.size() != 8)
    throw golden::InputError(place,
                             fmt::format("found {} numbers, want OX,OY,OZ,DX,DY,DZ[,TMIN,TMAX]", numbers.size()));
  golden::Ray ray{{numbers[0], numbers[1], numbers[2]}, {numbers[3], numbers[4], numbers[5]}};
  if (numbers.size() == 8) {
    ray.t_min = numbers[6];
    ray.t_max = numbers[7];
  }
  golden::check_ray(ray, place);
  return ray;
}

OneRay trace_one_ray(const golden::Ray& ray, const TraceTrees& trees) {
  const golden::Mesh mesh = golden::load_scene(trees.scene);
  const TreePair pair = build_and_compress(mesh, trees);
  golden::Hit ours;
  golden::Hit other;
  OneRay result;
  result.json["float"] = through(golden::FloatTreeView(pair.floats), mesh, ray, ours);
  result.json["compressed"] = through(golden::CompressedTreeView(pair.compressed), mesh, ray, other);
  result.pass = ours == other;
  try {
    const EmbreeHit embree = EmbreeScene(mesh, true).trace(ray);
    const HitRelation relation = compare_hit(mesh, ray, ours, embree);
    result.json["embree"] = hit_json(embree.primitive, static_cast<double>(embree.t));
    result.json["embree"]["relation"] = kHitRelationNames[static_cast<std::size_t>(relation)];
    result.pass = result.pass && !is_mistake(relation);
  } catch (const Unavailable&) {
    result.json["embree"] = Json();
  }
  result.json["pass"] = result.pass;
  for (const auto& [name, json] : result.json.items()) result.text += fmt::format("{:<11} {}\n", name, json.dump());
  return result;
}

}  // namespace cbvh::testbench
