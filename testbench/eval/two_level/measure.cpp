// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/eval/two_level/measure.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "golden/build/builder.h"
#include "golden/build/node_tree.h"
#include "golden/build/two_level/faults.h"
#include "golden/build/two_level/two_level_sah.h"
#include "golden/scene/two_level/two_level_scenes.h"
#include "golden/tree/validate.h"
#include "golden/update/streaming.h"
#include "golden/update/top_down.h"
#include "testbench/eval/two_level/forest.h"
#include "testbench/progress.h"
#include "testbench/rtl/stream_tree.h"

namespace cbvh::testbench {

namespace {

using golden::Code;

/// One top level while it is measured.
class Measuring {
 public:
  Measuring(const Forest& forest, bool compressed, const golden::TopLevelBuilder& builder, unsigned repeats)
      : trees_(compressed ? forest.compressed_trees : forest.float_trees), world_(forest.world) {
    result_.scene = forest.scene.name;
    result_.top = builder.text();
    result_.objects = compressed ? "compressed" : "float";
    result_.build_seconds = fastest_build(builder, trees_, repeats, top_);
    result_.triangles = golden::instanced_triangles(forest.scene);
    result_.instances = forest.scene.instances.size();
    result_.references = top_.references.size();
    result_.object_pairs = forest.pairs;
    result_.objects_seconds = forest.build_seconds;
    result_.transformed = std::any_of(forest.scene.instances.begin(), forest.scene.instances.end(),
                                      [](const auto& placed) { return !golden::is_identity(placed.to_world); });
    result_.pairs = top_.tree.pairs.size();
    result_.depth = golden::depth(top_.tree);
    result_.sah = golden::two_level_sah(top_, trees_, world_);
    const std::vector<std::string> faults = golden::faults_of(top_, trees_, 1);
    check(faults.empty(), faults.empty() ? "" : faults.front());
  }

  void compress(Code code) {
    const golden::GridRules rules = rules_of(top_.tree);
    const golden::CompressedTree top_down = golden::compress_top_down(top_.tree, rules, code);
    check(golden::validate(top_down, top_.tree, 1).empty(), "the compressed top level does not enclose the float one");
    result_.sah_compressed = golden::two_level_sah(decoded(top_, top_down), trees_, world_);
    for (std::size_t depth = 1; depth <= kTreeletDepths; ++depth) {
      const int levels = static_cast<int>(depth);
      const golden::StreamingResult reference = golden::compress_streaming(top_.tree, rules, code, levels);
      const StreamedTree streamed = stream_tree(top_.tree, {rules, code, levels, Collector::full, RunOptions()});
      const std::string which =
          fmt::format("{} codes, treelets of {} levels", code == Code::relative ? "relative" : "modulo", depth);
      check(reference.tree.pairs == top_down.pairs, which + ": the golden's streamed tree is not the top-down one");
      check(streamed.tree.pairs == top_down.pairs, which + ": the RTL's streamed tree is not the top-down one");
      check(streamed.repairs == reference.counts.backtracks, which + ": the RTL backtracks otherwise than the golden");
      if (code == Code::modulo) result_.modulo.backtracks[depth - 1] = reference.counts.backtracks;
    }
  }

  TopLevelMeasure result() && { return std::move(result_); }

 private:
  void check(bool holds, const std::string& what) {
    ++result_.checks;
    if (!holds)
      result_.failures.push_back(
          fmt::format("{}, {} over {} trees: {}", result_.scene, result_.top, result_.objects, what));
  }

  const golden::InstancedTrees& trees_;
  const golden::Box& world_;
  golden::TopLevel top_;
  TopLevelMeasure result_;
};

/// A single tree over all triangles.
struct Single {
  double sah;  ///< relative to the same box
  double seconds;
};

Single build_single(const Forest& forest, const golden::Builder& builder) {
  const golden::Mesh mesh = golden::flatten(forest.scene);
  const auto start = std::chrono::steady_clock::now();
  const golden::FloatTree tree = builder.build(mesh);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const double world = golden::half_area(forest.world);
  return {golden::sah(tree) * (world > 0 ? golden::half_area(tree.scene) / world : 1.0), seconds};
}

}  // namespace

std::vector<TopLevelMeasure> measure_two_level(const TwoLevelJob& job) {
  const golden::Builder objects("--objects", job.objects);
  std::vector<golden::TopLevelBuilder> tops;
  for (const std::string& text : job.tops) tops.emplace_back("--top", text);
  std::vector<golden::TwoLevelScene> scenes;
  for (const std::string& scene : job.scenes) scenes.push_back(golden::load_two_level_scene(scene));
  std::vector<TopLevelMeasure> results;
  Progress progress("eval two-level", scenes.size() * (1 + tops.size() * 2));
  for (golden::TwoLevelScene& scene : scenes) {
    const Forest forest(std::move(scene), objects);
    std::optional<Single> single;
    if (golden::instanced_triangles(forest.scene) <= job.most_single) single = build_single(forest, objects);
    progress.step();
    for (const golden::TopLevelBuilder& top : tops) {
      for (const bool compressed : {false, true}) {
        Measuring measuring(forest, compressed, top, job.repeats);
        for (const Code code : {Code::relative, Code::modulo}) measuring.compress(code);
        results.push_back(std::move(measuring).result());
        if (single) {
          results.back().sah_single = single->sah;
          results.back().single_seconds = single->seconds;
        }
        progress.step();
      }
    }
  }
  return results;
}

}  // namespace cbvh::testbench
