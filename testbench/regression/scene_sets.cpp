// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/regression/scene_sets.h"

#include "golden/quantize/scale.h"
#include "golden/update/streaming.h"
#include "golden/update/top_down.h"
#include "testbench/rtl/stream_tree.h"
#include "testbench/scoreboard/compare_trees.h"

namespace cbvh::testbench {

namespace {

void check_tree(const golden::FloatTree& floats, StreamOptions stream, const TreeCase& tree_case, SetReport& report) {
  stream.rules.min_scale = golden::exactness_limit(floats.largest_magnitude);
  const StreamedTree streamed = stream_tree(floats, stream);
  const auto counts = golden::compress_streaming(floats, stream.rules, stream.code, stream.treelet).counts;
  compare_trees(golden::compress_top_down(floats, stream.rules, stream.code), streamed.tree, tree_case, report);
  compare_number("backtracks", static_cast<long long>(counts.backtracks), static_cast<long long>(streamed.repairs),
                 tree_case, report);
  ++report.cases;
  report.cycles += streamed.cycles;
}

std::string set_name(const std::string& spec, const StreamOptions& stream) {
  return fmt::format("tree {} bits={} treelet={} {} {}", spec, stream.rules.bits, stream.treelet,
                     stream.code == golden::Code::modulo ? "modulo" : "relative",
                     stream.collector == Collector::full ? "full" : "lazy");
}

/// The combinations that one scene is streamed with.
std::vector<StreamOptions> combinations(const std::vector<int>& treelets, const std::vector<int>& bits,
                                        const std::vector<RunOptions>& modes) {
  std::vector<StreamOptions> all;
  StreamOptions usual;
  usual.run = modes[0];
  for (const golden::Code code : {golden::Code::modulo, golden::Code::relative}) {
    for (const int treelet : treelets) {
      for (const Collector collector : {Collector::full, Collector::lazy}) {
        StreamOptions& stream = all.emplace_back(usual);
        stream.code = code;
        stream.treelet = treelet;
        stream.collector = collector;
      }
    }
  }
  for (std::size_t mode = 1; mode < modes.size(); ++mode) all.emplace_back(usual).run = modes[mode];
  for (const int width : bits) {
    if (width != usual.rules.bits) all.emplace_back(usual).rules.bits = width;
  }
  return all;
}

}  // namespace

void append_scene_sets(const std::vector<Scene>& scenes, const std::vector<int>& treelets, const std::vector<int>& bits,
                       const std::vector<RunOptions>& modes, const RegressionOptions& options,
                       std::vector<PlannedSet>& plan) {
  std::uint64_t number = 0;
  for (const auto& [spec, floats] : scenes) {
    for (const StreamOptions& stream : combinations(treelets, bits, modes)) {
      PlannedSet set;
      set.report.unit = kSceneUnit;
      set.report.set = set_name(spec, stream);
      set.report.backend = "rtl";
      set.report.mode = mode_name(stream.run);
      set.report.total_cases = 1;
      set.run = stream.run;
      set.first_id = number++;
      RegressionOptions of_scene = options;
      of_scene.scenes = {spec};
      const std::string rerun = rerun_line(of_scene, set);
      set.work = [floats = floats, stream, rerun](const std::vector<std::uint64_t>& ids, SetReport& report) {
        for (const std::uint64_t id : ids) check_tree(*floats, stream, {id, "tree", rerun}, report);
      };
      plan.push_back(set);
    }
  }
}

}  // namespace cbvh::testbench
