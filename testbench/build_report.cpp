// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/build_report.h"

#include <fmt/format.h>

#include <chrono>

#include "golden/build/builder.h"
#include "golden/build/node_tree.h"
#include "golden/quantize/scale.h"
#include "golden/tree/digest.h"
#include "golden/tree/sah.h"
#include "golden/tree/validate.h"
#include "golden/update/streaming.h"
#include "golden/update/top_down.h"
#include "golden/update/traffic.h"

namespace cbvh::testbench {

namespace {

Json traffic_to_json(const golden::Traffic& traffic) {
  return {{"baseline_bytes", traffic.baseline_bytes},
          {"streaming_bytes", traffic.streaming_bytes},
          {"ratio", traffic.ratio()}};
}

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

bool same_root(const golden::CompressedTree& a, const golden::CompressedTree& b) { return a.root == b.root; }

}  // namespace

BuildResult build_and_compare(const golden::Mesh& mesh, const BuildJob& job) {
  const golden::Builder builder("--builder", job.builder);
  const auto start = std::chrono::steady_clock::now();
  const golden::FloatTree floats = builder.build(mesh);
  const double build_seconds = seconds_since(start);
  StreamOptions stream = job.stream;
  stream.rules.min_scale = job.min_scale.value_or(golden::exactness_limit(floats.largest_magnitude));
  StreamedTree streamed;
  if (!job.golden_streaming) streamed = stream_tree(floats, stream);  // first: it may refuse
  const golden::StreamingResult reference =
      golden::compress_streaming(floats, stream.rules, stream.code, stream.treelet);
  if (job.golden_streaming) streamed.tree = reference.tree;
  const golden::CompressedTree top_down = golden::compress_top_down(floats, stream.rules, stream.code);
  const bool identical = streamed.tree.pairs == top_down.pairs && same_root(streamed.tree, top_down);
  const bool same_backtracks = job.golden_streaming || streamed.repairs == reference.counts.backtracks;
  const auto violations = golden::validate(streamed.tree, floats);
  const auto traffic =
      golden::update_traffic(floats.primitive_ids.size(), floats.pairs.size(), reference.counts.backtracks);
  Json texts = Json::array();
  for (const golden::Violation& violation : violations) texts.push_back(golden::to_string(violation));
  Json json = {{"treelet", stream.treelet},
               {"bits", stream.rules.bits},
               {"triangles", floats.primitives},
               {"references", floats.primitive_ids.size()},
               {"leaves", floats.leaves},
               {"pairs", floats.pairs.size()},
               {"depth", golden::depth(floats)},
               {"e_min", stream.rules.min_scale},
               {"root_exponents", {top_down.root[0].scale, top_down.root[1].scale, top_down.root[2].scale}},
               {"digest", fmt::format("{:016x}", golden::digest(streamed.tree))},
               {"topdown_digest", fmt::format("{:016x}", golden::digest(top_down))},
               {"identical", identical},
               {"streamed_by", job.golden_streaming ? "golden" : "rtl"},
               {"backtracks", reference.counts.backtracks},
               {"hardware_backtracks", job.golden_streaming ? Json() : Json(streamed.repairs)},
               {"backtrack_depth_histogram", reference.counts.depth_histogram},
               {"traffic", {{"lbvh", traffic_to_json(traffic.lbvh)}, {"refit", traffic_to_json(traffic.refit)}}},
               {"sah", {{"float", golden::sah(floats)}, {"quantized", golden::sah(streamed.tree)}}},
               {"violations", violations.size()},
               {"violation_texts", texts},
               {"cycles", streamed.cycles}};
  json["build_seconds"] = build_seconds;
  json["seconds"] = seconds_since(start);
  return {std::move(streamed.tree), std::move(json), identical && same_backtracks && violations.empty()};
}

std::string to_text(const std::string& scene, const Json& figures) {
  std::string text = fmt::format("{}\n", scene);
  for (const auto& [key, value] : figures.items()) text += fmt::format("  {:<26} {}\n", key, value.dump());
  text += figures["identical"].get<bool>() ? "identical to the top-down tree" : "DIFFERS from the top-down tree";
  return text + fmt::format(", {} violations\n", figures["violations"].get<std::size_t>());
}

}  // namespace cbvh::testbench
