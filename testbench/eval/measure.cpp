// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/eval/measure.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <numeric>

#include "golden/build/lbvh.h"
#include "golden/input_error.h"
#include "golden/quantize/scale.h"
#include "golden/scene/load.h"
#include "golden/threads/parallel_for.h"
#include "golden/tree/digest.h"
#include "golden/tree/sah.h"
#include "golden/update/streaming.h"
#include "golden/update/top_down.h"
#include "testbench/progress.h"

namespace cbvh::testbench {

namespace {

using golden::Code;

constexpr std::array kCodes = {Code::relative, Code::modulo};

/// A scene while it is measured. Every piece of work writes a field of its own.
struct Work {
  golden::Mesh mesh;
  golden::FloatTree floats;
  std::uint64_t top_down = 0;
  std::array<std::array<std::uint64_t, kTreeletDepths>, kCodes.size()> streamed{};  ///< digests
};

using Piece = std::function<void()>;

golden::GridRules grid_rules(const golden::FloatTree& floats, const EvalRules& rules, std::optional<int> min_scale) {
  return {6, min_scale.value_or(golden::exactness_limit(floats.largest_magnitude)), rules.scale_rule};
}

void measure_top_down(const EvalRules& rules, Work& work, SceneMeasure& scene) {
  const golden::GridRules grid = grid_rules(work.floats, rules, rules.min_scale);
  const golden::CompressedTree tree = golden::compress_top_down(work.floats, grid, Code::modulo);
  scene.min_scale = grid.min_scale;
  scene.sah_float = golden::sah(work.floats);
  scene.sah_quantized = golden::sah(tree);
  work.top_down = golden::digest(tree);
}

void measure_streaming(const EvalRules& rules, std::size_t code, std::size_t depth, Work& work, CodeCounts& counts) {
  golden::StreamingResult result = golden::compress_streaming(
      work.floats, grid_rules(work.floats, rules, rules.min_scale), kCodes[code], static_cast<int>(depth) + 1);
  work.streamed[code][depth] = golden::digest(result.tree);
  counts.backtracks[depth] = result.counts.backtracks;
  if (depth == 0) counts.depth_histogram = std::move(result.counts.depth_histogram);
}

void measure_sweep(const EvalRules& rules, const Work& work, SweepPoint& point) {
  const golden::GridRules grid = grid_rules(work.floats, rules, point.min_scale);
  const golden::StreamingResult one = golden::compress_streaming(work.floats, grid, Code::modulo, 1);
  point.one_level = one.counts.backtracks;
  point.sah = golden::sah(one.tree);
  point.four_levels = golden::compress_streaming(work.floats, grid, Code::modulo, 4).counts.backtracks;
}

std::size_t pieces_per_scene(const EvalJob& job) {
  return job.sweep.size() + 1 + kCodes.size() * kTreeletDepths + (job.runtime ? 1 : 0);
}

/// Everything there is to measure of a built scene: pieces_per_scene of them.
void add_pieces(const EvalJob& job, Work& work, SceneMeasure& scene, std::vector<Piece>& pieces) {
  for (const std::optional<int> min_scale : job.sweep) scene.sweep.push_back({min_scale, 0, 0, 0});
  for (SweepPoint& point : scene.sweep) pieces.push_back([&] { measure_sweep(job.rules, work, point); });
  pieces.push_back([&] { measure_top_down(job.rules, work, scene); });
  for (std::size_t code = 0; code < kCodes.size(); ++code) {
    CodeCounts& counts = kCodes[code] == Code::relative ? scene.relative : scene.modulo;
    for (std::size_t depth = 0; depth < kTreeletDepths; ++depth)
      pieces.push_back(
          [&job, &work, &counts, code, depth] { measure_streaming(job.rules, code, depth, work, counts); });
  }
  if (job.runtime) pieces.push_back([&] { scene.runtime = job.runtime(work.mesh, job.rules); });
}

void check_trees(const Work& work, SceneMeasure& scene) {
  for (std::size_t code = 0; code < kCodes.size(); ++code) {
    for (std::size_t depth = 0; depth < kTreeletDepths; ++depth) {
      ++scene.checks;
      if (work.streamed[code][depth] == work.top_down) continue;
      scene.failures.push_back(
          fmt::format("{}: {} codes, treelets of {} levels: the streamed tree differs from the "
                      "top-down one",
                      scene.name, code == 0 ? "relative" : "modulo", depth + 1));
    }
  }
}

void check_code_depths(const char* code, const CodeCounts& counts, SceneMeasure& scene) {
  const auto& histogram = counts.depth_histogram;
  for (std::size_t depth = 1; depth <= kTreeletDepths; ++depth) {
    const auto first = histogram.begin() + static_cast<std::ptrdiff_t>(std::min(depth, histogram.size()));
    const std::uint64_t below = std::accumulate(first, histogram.end(), std::uint64_t{0});
    ++scene.checks;
    if (below == counts.backtracks[depth - 1]) continue;
    scene.failures.push_back(
        fmt::format("{}: {} codes: {} backtracks with treelets of {} levels, but {} at depth {} "
                    "and below without",
                    scene.name, code, counts.backtracks[depth - 1], depth, below, depth));
  }
}

void check_scenes(const std::vector<std::string>& scenes) {
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    if (std::find(scenes.begin(), scenes.begin() + static_cast<std::ptrdiff_t>(i), scenes[i]) !=
        scenes.begin() + static_cast<std::ptrdiff_t>(i))
      throw golden::InputError(scenes[i], "scene: given twice, want each scene once");
  }
}

/// Two files of one name are told apart by their paths.
void tell_apart(const std::vector<std::string>& paths, std::vector<SceneMeasure>& scenes) {
  std::vector<std::string> names;
  names.reserve(scenes.size());
  for (const SceneMeasure& scene : scenes) names.push_back(scene.name);
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    if (std::count(names.begin(), names.end(), names[i]) > 1) scenes[i].name = paths[i];
  }
}

}  // namespace

void check_depths(SceneMeasure& scene) {
  check_code_depths("relative", scene.relative, scene);
  check_code_depths("modulo", scene.modulo, scene);
}

std::vector<SceneMeasure> measure_scenes(const EvalJob& job) {
  check_scenes(job.scenes);
  std::vector<Work> works(job.scenes.size());
  std::vector<SceneMeasure> scenes(job.scenes.size());
  Progress progress("eval", scenes.size() * (1 + pieces_per_scene(job)));
  golden::parallel_for(scenes.size(), job.threads, [&](std::size_t i) {
    works[i].mesh = golden::load_scene(job.scenes[i]);
    works[i].floats = golden::build_lbvh(works[i].mesh);
    scenes[i].name = works[i].mesh.name;
    scenes[i].triangles = works[i].floats.primitives;
    scenes[i].leaves = works[i].floats.leaves;
    scenes[i].pairs = works[i].floats.pairs.size();
    if (!job.runtime) works[i].mesh = {};
    progress.step();
  });
  tell_apart(job.scenes, scenes);
  std::vector<Piece> pieces;
  for (std::size_t i = 0; i < scenes.size(); ++i) add_pieces(job, works[i], scenes[i], pieces);
  golden::parallel_for(pieces.size(), job.threads, [&](std::size_t i) {
    pieces[i]();
    progress.step();
  });
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    check_trees(works[i], scenes[i]);
    check_depths(scenes[i]);
  }
  return scenes;
}

}  // namespace cbvh::testbench
