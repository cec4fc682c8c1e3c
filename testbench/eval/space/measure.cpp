// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/eval/space/measure.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "golden/build/builder.h"
#include "golden/build/check_tree.h"
#include "golden/build/node_tree.h"
#include "golden/build/overlap_penalty.h"
#include "golden/input_error.h"
#include "golden/scene/load.h"
#include "golden/tree/coverage.h"
#include "golden/tree/sah.h"
#include "testbench/eval/space/ray_cost.h"
#include "testbench/progress.h"

namespace cbvh::testbench {

namespace {

MeanRay mean(const golden::TraceCounts& counts, std::uint64_t rays) {
  const auto number = static_cast<double>(rays);
  return {static_cast<double>(counts.pairs) / number, static_cast<double>(counts.triangle_tests) / number};
}

/// The trees of one scene while they are measured.
class Measuring {
 public:
  Measuring(const golden::Mesh& mesh, const SpaceJob& job) : mesh_(mesh), job_(job) {}

  SpaceMeasure measure(const SpaceTree& tree) {
    SpaceMeasure result;
    result.scene = mesh_.name;
    result.tree = tree.name;
    result.triangles = mesh_.triangles.size();
    result.builder = builder_text(tree, result.triangles);
    const golden::Builder builder("builder", result.builder);
    const auto start = std::chrono::steady_clock::now();
    const golden::FloatTree floats = builder.build(mesh_);
    result.build_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (golden::volume(floats.scene) <= 0)
      throw golden::InputError(mesh_.name, "its box has no volume, want one for random rays");
    result.references = floats.primitive_ids.size();
    result.bytes = 64 * floats.pairs.size() + 4 * result.references;
    result.depth = golden::depth(floats);
    result.expected = golden::sah(floats, {kSpaceTraversal, kSpaceIntersection});
    const RayCosts terminating = trace(floats, RandomRays::terminating);
    const RayCosts through = trace(floats, RandomRays::through);
    result.terminating = mean(terminating.counts, job_.rays);
    result.through = mean(through.counts, job_.rays);
    check(result, golden::check_tree(floats, mesh_, 1).empty(), "the float tree is not what a builder promises");
    const auto stride = static_cast<std::uint32_t>(std::max<std::uint64_t>(1, result.triangles / job_.covered));
    check(result, golden::coverage_gaps(floats, mesh_, stride, 1).empty(), "leaves do not cover a triangle");
    check_hits(result, terminating.hits, terminating_hits_);
    check_hits(result, through.hits, through_hits_);
    return result;
  }

 private:
  RayCosts trace(const golden::FloatTree& tree, RandomRays kind) const {
    return trace_random_rays(tree, mesh_, kind, job_.rays, job_.threads);
  }

  static void check(SpaceMeasure& result, bool holds, const std::string& what) {
    ++result.checks;
    if (!holds) result.failures.push_back(fmt::format("{}, {}: {}", result.scene, result.builder, what));
  }

  void check_hits(SpaceMeasure& result, const std::vector<golden::Hit>& hits, std::vector<golden::Hit>& first) const {
    if (first.empty()) {  // the first tree: there is nothing to compare with yet
      first = hits;
      return;
    }
    const auto [found, wanted] = std::mismatch(hits.begin(), hits.end(), first.begin());
    check(result, found == hits.end(),
          fmt::format("ray {} does not hit what it hits through the first tree", found - hits.begin()));
  }

  const golden::Mesh& mesh_;
  const SpaceJob& job_;
  std::vector<golden::Hit> terminating_hits_;
  std::vector<golden::Hit> through_hits_;
};

}  // namespace

SpaceMeasures measure_space(const SpaceJob& job) {
  std::vector<SpaceTree> trees;
  for (const std::string& builder : job.builders) {
    const golden::Builder named("--builder", builder);
    trees.push_back({named.text(), named.text()});
  }
  if (trees.empty()) trees = paper_space_trees();
  for (const double penalty : job.penalties) const golden::Builder named("--overlap", overlap_tree(penalty).builder);
  std::vector<golden::Mesh> meshes;
  for (const std::string& scene : job.scenes) meshes.push_back(golden::load_scene(scene));
  Progress progress("eval space", meshes.size() * (trees.size() + job.penalties.size()));
  SpaceMeasures results;
  for (const golden::Mesh& mesh : meshes) {
    Measuring measuring(mesh, job);
    for (const SpaceTree& tree : trees) {
      results.trees.push_back(measuring.measure(tree));
      progress.step();
    }
    for (const double penalty : job.penalties) {
      results.overlap.push_back(measuring.measure(overlap_tree(penalty)));
      results.overlap.back().overlap = penalty;
      progress.step();
    }
  }
  return results;
}

}  // namespace cbvh::testbench
