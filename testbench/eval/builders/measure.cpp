// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/eval/builders/measure.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "golden/build/builder.h"
#include "golden/build/check_tree.h"
#include "golden/build/node_tree.h"
#include "golden/quantize/scale.h"
#include "golden/scene/load.h"
#include "golden/tree/sah.h"
#include "golden/tree/validate.h"
#include "golden/update/streaming.h"
#include "golden/update/top_down.h"
#include "testbench/progress.h"
#include "testbench/rtl/stream_tree.h"

namespace cbvh::testbench {

namespace {

using golden::Code;

/// One tree while it is measured.
class Measuring {
 public:
  Measuring(const golden::Mesh& mesh, const golden::Builder& builder, unsigned repeats) {
    result_.scene = mesh.name;
    result_.builder = builder.text();
    for (unsigned i = 0; i < repeats; ++i) {
      const auto start = std::chrono::steady_clock::now();
      floats_ = builder.build(mesh);
      const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
      result_.build_seconds = i == 0 ? seconds : std::min(seconds, result_.build_seconds);
    }
    result_.triangles = floats_.primitives;
    result_.references = floats_.primitive_ids.size();
    result_.leaves = floats_.leaves;
    result_.pairs = floats_.pairs.size();
    result_.depth = golden::depth(floats_);
    result_.sah_float = golden::sah(floats_);
    rules_.min_scale = golden::exactness_limit(floats_.largest_magnitude);
    check(golden::check_tree(floats_, mesh, 1).empty(), "the float tree is not what a builder promises");
  }

  void compress(Code code) {
    CodeCounts& counts = code == Code::relative ? result_.relative : result_.modulo;
    const golden::CompressedTree top_down = golden::compress_top_down(floats_, rules_, code);
    check(golden::validate(top_down, floats_, 1).empty(), "the compressed tree does not enclose the float tree");
    result_.sah_quantized = golden::sah(top_down);
    for (std::size_t depth = 1; depth <= kTreeletDepths; ++depth) {
      golden::StreamingResult reference = golden::compress_streaming(floats_, rules_, code, static_cast<int>(depth));
      const StreamedTree streamed =
          stream_tree(floats_, {rules_, code, static_cast<int>(depth), Collector::full, RunOptions()});
      const std::string which =
          fmt::format("{} codes, treelets of {} levels", code == Code::relative ? "relative" : "modulo", depth);
      check(reference.tree.pairs == top_down.pairs, which + ": the golden's streamed tree is not the top-down one");
      check(streamed.tree.pairs == top_down.pairs, which + ": the RTL's streamed tree is not the top-down one");
      check(streamed.repairs == reference.counts.backtracks, which + ": the RTL backtracks otherwise than the golden");
      counts.backtracks[depth - 1] = reference.counts.backtracks;
      if (depth == 1) counts.depth_histogram = std::move(reference.counts.depth_histogram);
    }
  }

  BuilderMeasure result() && { return std::move(result_); }

 private:
  void check(bool holds, const std::string& what) {
    ++result_.checks;
    if (!holds) result_.failures.push_back(fmt::format("{}, {}: {}", result_.scene, result_.builder, what));
  }

  BuilderMeasure result_;
  golden::FloatTree floats_;
  golden::GridRules rules_;
};

}  // namespace

std::vector<BuilderMeasure> measure_builders(const BuildersJob& job) {
  std::vector<golden::Builder> builders;
  for (const std::string& text : job.builders) builders.emplace_back("--builder", text);
  std::vector<golden::Mesh> meshes;
  for (const std::string& scene : job.scenes) meshes.push_back(golden::load_scene(scene));
  std::vector<BuilderMeasure> results;
  Progress progress("eval builders", meshes.size() * builders.size() * 3);
  for (const golden::Mesh& mesh : meshes) {
    for (const golden::Builder& builder : builders) {
      Measuring measuring(mesh, builder, job.repeats);
      progress.step();
      for (const Code code : {Code::relative, Code::modulo}) {
        measuring.compress(code);
        progress.step();
      }
      results.push_back(std::move(measuring).result());
    }
  }
  return results;
}

}  // namespace cbvh::testbench
